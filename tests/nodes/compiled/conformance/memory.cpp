// Where a subscription's messages come from: the program's own strategies.
#include "check.hpp"
#include "rclcpp/strategies/message_pool_memory_strategy.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;
using rclcpp::message_memory_strategy::MessageMemoryStrategy;

/// It counts what it lends, and what comes back.
struct Counting : MessageMemoryStrategy<Int32>
{
  std::shared_ptr<Int32> borrow_message() override
  {
    ++lent;
    return last = MessageMemoryStrategy<Int32>::borrow_message();
  }
  void return_message(std::shared_ptr<Int32> & message) override
  {
    back += message == last;
    MessageMemoryStrategy<Int32>::return_message(message);
  }
  std::shared_ptr<Int32> last;
  int lent = 0, back = 0;
};

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("borrower");
  auto publisher = node->create_publisher<Int32>("number", 10);
  auto counting = std::make_shared<Counting>();
  const Int32 * heard = nullptr;
  {
    auto subscription = node->create_subscription<Int32>(
      "number", 10, [&](Int32::ConstSharedPtr message) {heard = message.get();}, rclcpp::SubscriptionOptions(), counting);
    publisher->publish(Int32().set__data(1));
    spin_until(node, [&] {return heard != nullptr;});
    check("the callback has the strategy's message", heard == counting->last.get() && heard->data == 1);
    check("and gives it back", counting->lent == 1 && counting->back == 1);
    std::shared_ptr<void> made = subscription->create_message();
    check("so do messages by hand", made == counting->last);
    subscription->return_message(made);
    check("they are given back, too", counting->back == 2 && !made);
  }

  using Pool = rclcpp::strategies::message_pool_memory_strategy::MessagePoolMemoryStrategy<Int32, 2>;
  auto pool = std::make_shared<Pool>();
  auto first = pool->borrow_message(), second = pool->borrow_message();
  throws<std::runtime_error>("more than the pool has", [&] {pool->borrow_message();});
  first->data = 5;
  pool->return_message(first);
  pool->return_message(second);
  auto stranger = std::make_shared<Int32>();
  throws<std::runtime_error>("what is not of the pool", [&] {pool->return_message(stranger);});
  auto next = pool->borrow_message(), again = pool->borrow_message();
  check("the pool's messages come again, as good as new", again == first && first->data == 0 && next == second);
  pool->return_message(next);
  pool->return_message(again);
  std::set<const Int32 *> places;
  int sum = 0;
  auto pooled = node->create_subscription<Int32>(
    "number", 10, [&](Int32::SharedPtr message) {sum += message->data;}, rclcpp::SubscriptionOptions(), pool);
  auto looking = node->create_subscription<Int32>(
    "number", 10, [&](const Int32 & message) {places.insert(&message);}, rclcpp::SubscriptionOptions(), pool);
  for (int i = 1; i <= 4; ++i) {
    publisher->publish(Int32().set__data(i));
    spin_until(node, [&] {return sum == i * (i + 1) / 2;});
  }
  spin_until(node, [&] {return sum == 10 && !places.empty();});
  equal("a pool serves all messages", sum, 10);
  check("from its places", places.size() == 1 || places.size() == 2, std::to_string(places.size()));
  auto text = MessageMemoryStrategy<Int32>::create_default()->borrow_serialized_message(16);
  equal("bytes of a capacity", text->capacity(), 16u);
  rclcpp::shutdown();
}
