// Waitables of a program's own, in executors and in wait sets.
#include "check.hpp"
#include "rclcpp/waitable.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;

/// Hands numbers to whoever executes it.
class Numbers : public rclcpp::Waitable
{
public:
  void put(int number)
  {
    std::lock_guard<std::mutex> hold(lock_);
    waiting_.push_back(number);
    guard_.trigger();
  }
  size_t get_number_of_ready_guard_conditions() override {return 1;}
  void add_to_wait_set(rcl_wait_set_t * wait_set) override
  {
    ++added;
    guard_.add_to_wait_set(wait_set);
  }
  bool is_ready(rcl_wait_set_t * wait_set) override
  {
    for (size_t i = 0; i < wait_set->size_of_guard_conditions; ++i) {
      if (wait_set->guard_conditions[i] == &guard_.get_rcl_guard_condition()) {
        std::lock_guard<std::mutex> hold(lock_);
        return !waiting_.empty();
      }
    }
    return false;
  }
  std::shared_ptr<void> take_data() override
  {
    std::lock_guard<std::mutex> hold(lock_);
    auto taken = std::make_shared<int>(waiting_.front());
    waiting_.pop_front();
    if (!waiting_.empty()) {
      guard_.trigger();
    }
    return taken;
  }
  void execute(std::shared_ptr<void> & data) override {sum += *std::static_pointer_cast<int>(data);}
  std::atomic<int> sum{0}, added{0};

private:
  std::mutex lock_;
  std::list<int> waiting_;
  rclcpp::GuardCondition guard_;
};

/// Takes a subscription's messages itself.
class Hears : public rclcpp::Waitable
{
public:
  explicit Hears(rclcpp::Subscription<Int32>::SharedPtr subscription)
  : subscription_(subscription) {}
  size_t get_number_of_ready_subscriptions() override {return 1;}
  void add_to_wait_set(rcl_wait_set_t * wait_set) override
  {
    rcl_wait_set_add_subscription(wait_set, subscription_->get_subscription_handle().get(), &index_);
  }
  bool is_ready(rcl_wait_set_t * wait_set) override {return wait_set->subscriptions[index_] != nullptr;}
  std::shared_ptr<void> take_data() override
  {
    auto message = std::make_shared<Int32>();
    rclcpp::MessageInfo info;
    return subscription_->take(*message, info) ? message : nullptr;
  }
  void execute(std::shared_ptr<void> & data) override {last = std::static_pointer_cast<Int32>(data)->data;}
  std::atomic<int> last{0};

private:
  rclcpp::Subscription<Int32>::SharedPtr subscription_;
  size_t index_ = 0;
};

void said(
  const std::string & name, rclcpp::Executor & executor, rclcpp::Node::SharedPtr node, std::shared_ptr<Numbers> numbers)
{
  executor.add_node(node);
  int before = numbers->sum;
  std::thread puts([&] {
      rclcpp::sleep_for(20ms);
      numbers->put(2);
      numbers->put(3);
    });
  auto end = node->create_wall_timer(5ms, [&] {if (numbers->sum >= before + 5) {executor.cancel();}});
  executor.spin();
  puts.join();
  executor.remove_node(node);
  equal(name, numbers->sum - before, 5);
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waits");
  auto waitables = node->get_node_waitables_interface();
  auto numbers = std::make_shared<Numbers>();
  waitables->add_waitable(numbers, nullptr);
  check("it is asked what to wait for", numbers->added > 0);
  numbers->put(1);
  check("an executor executes it", spin_until(node, [&] {return numbers->sum == 1;}));
  rclcpp::executors::SingleThreadedExecutor single;
  rclcpp::executors::MultiThreadedExecutor several;
  rclcpp::executors::StaticSingleThreadedExecutor fixed_one;
  said("also one that waits already", single, node, numbers);
  said("also one of several threads", several, node, numbers);
  said("also the static one", fixed_one, node, numbers);
  waitables->remove_waitable(numbers, nullptr);
  int before = numbers->sum;
  numbers->put(7);
  rclcpp::spin_some(node);
  equal("one that was removed is not", numbers->sum.load(), before);
  auto other = rclcpp::Node::make_shared("other");
  auto foreign = other->create_callback_group(rclcpp::CallbackGroupType::Reentrant);
  throws<std::runtime_error>("a group of another node", [&] {waitables->add_waitable(numbers, foreign);});
  auto own = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  auto apart = std::make_shared<Numbers>();
  waitables->add_waitable(apart, own);
  apart->put(4);
  rclcpp::spin_some(node);
  equal("a group apart is left alone", apart->sum.load(), 0);
  rclcpp::executors::SingleThreadedExecutor of_group;
  of_group.add_callback_group(own, node->get_node_base_interface());
  of_group.spin_once(1s);
  equal("its executor serves it", apart->sum.load(), 4);

  // what a waitable waits for may be anything
  auto manual = node->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false);
  rclcpp::SubscriptionOptions options;
  options.callback_group = manual;
  bool called = false;
  auto subscription = node->create_subscription<Int32>("heard", 10, [&](const Int32 &) {called = true;}, options);
  auto hears = std::make_shared<Hears>(subscription);
  waitables->add_waitable(hears, nullptr);
  auto publisher = other->create_publisher<Int32>("heard", 10);
  publisher->publish(Int32().set__data(5));
  check("a waitable takes messages", spin_until(node, [&] {return hears->last == 5;}) && !called);
  waitables->remove_waitable(hears, nullptr);

  // wait sets
  rclcpp::WaitSet set;
  auto alone = std::make_shared<Numbers>();
  set.add_waitable(alone);
  throws<std::runtime_error>("a waitable is in one set", [&] {rclcpp::WaitSet().add_waitable(alone);});
  throws<std::invalid_argument>("no waitable", [&] {set.add_waitable(nullptr);});
  check("nothing is ready", set.wait(20ms).kind() == rclcpp::WaitResultKind::Timeout);
  alone->put(6);
  auto result = set.wait(1s);
  check("it ends a wait", result.kind() == rclcpp::WaitResultKind::Ready);
  rcl_wait_set_t found = result.get_wait_set().get_rcl_wait_set();
  check("and is told that it is ready", alone->is_ready(&found));
  auto data = alone->take_data();
  alone->execute(data);
  equal("it is executed by hand", alone->sum.load(), 6);
  set.remove_waitable(alone);
  throws<std::runtime_error>("a waitable removed twice", [&] {set.remove_waitable(alone);});
  check("the set is empty", set.wait(20ms).kind() == rclcpp::WaitResultKind::Empty);
  using Fixed = rclcpp::StaticWaitSet<0, 0, 0, 0, 0, 1>;
  Fixed fixed({}, {}, {}, {}, {}, {{{alone}}});
  alone->put(1);
  check("in a set of fixed size", fixed.wait(1s).kind() == rclcpp::WaitResultKind::Ready);

  // what all have
  throws<std::runtime_error>("on ready is for who overrides it", [&] {alone->set_on_ready_callback({});});
  throws<std::runtime_error>("and so is its clearing", [&] {alone->clear_on_ready_callback();});
  throws<std::runtime_error>("data by entity too", [&] {alone->take_data_by_entity_id(0);});
  rclcpp::shutdown();
}
