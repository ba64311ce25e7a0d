#include "check.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;
using Kind = rclcpp::WaitResultKind;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waiter");
  auto first = node->create_subscription<Int32>("number", 10, [](Int32::UniquePtr) {});
  auto second = node->create_subscription<Int32>("number", 10, [](Int32::UniquePtr) {});
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto publisher = node->create_publisher<Int32>("number", 1);
  rclcpp::WaitSet set({}, std::vector<rclcpp::GuardCondition::SharedPtr>{guard});
  set.add_subscription(first);
  set.add_subscription(second);
  throws<std::runtime_error>("added twice", [&] {set.add_subscription(first);});
  throws<std::invalid_argument>("nothing added", [&] {set.add_subscription(nullptr);});
  check("nothing comes", set.wait(20ms).kind() == Kind::Timeout);
  guard->trigger();
  auto result = set.wait(1s);
  check("a guard condition ends the wait", result.kind() == Kind::Ready);
  check("it is told", result.get_wait_set().get_rcl_wait_set().guard_conditions[0] != nullptr);
  check("and nothing else", result.get_wait_set().get_rcl_wait_set().subscriptions[0] == nullptr);
  check("it is lowered", set.wait(20ms).kind() == Kind::Timeout);
  throws<std::runtime_error>("a timeout has no set", [&] {(void)set.wait(1ms).get_wait_set();});
  publisher->publish(Int32().set__data(4));
  auto came = set.wait(1s);
  check("a message ends it", came.kind() == Kind::Ready);
  equal("there are two subscriptions", came.get_wait_set().get_rcl_wait_set().size_of_subscriptions, 2u);
  check("both are ready", set.get_rcl_wait_set().subscriptions[0] && set.get_rcl_wait_set().subscriptions[1]);
  Int32 message;
  rclcpp::MessageInfo info;
  check("it is taken", first->take(message, info) && message.data == 4);
  check("once", !first->take(message, info));
  check("the other has its own", second->take(message, info));
  set.remove_subscription(second);
  throws<std::runtime_error>("removed twice", [&] {set.remove_subscription(second);});
  equal("one is left", set.get_rcl_wait_set().size_of_subscriptions, 1u);
  rclcpp::WaitSet other;
  check("an empty one", other.wait(1s).kind() == Kind::Empty);
  throws<std::runtime_error>("a guard condition is in one set", [&] {other.add_guard_condition(guard);});
  int rung = 0;
  auto timer = node->create_wall_timer(20ms, [&] {++rung;});
  rclcpp::WaitSet timers({}, {}, {timer});
  check("a timer ends it", timers.wait(1s).kind() == Kind::Ready);
  check("it is called by hand", timer->call());
  timer->execute_callback();
  equal("and its callback", rung, 1);
  std::thread raise([&] {
      rclcpp::sleep_for(50ms);
      guard->trigger();
    });
  check("another thread ends it", set.wait().kind() == Kind::Ready);
  raise.join();
  using Fixed = rclcpp::StaticWaitSet<1, 1, 0, 0, 0, 0>;
  auto own_guard = std::make_shared<rclcpp::GuardCondition>();
  Fixed fixed(
    std::array<Fixed::SubscriptionEntry, 1>{{{second}}}, std::array<rclcpp::GuardCondition::SharedPtr, 1>{{own_guard}},
    std::array<rclcpp::TimerBase::SharedPtr, 0>{}, std::array<rclcpp::ClientBase::SharedPtr, 0>{},
    std::array<rclcpp::ServiceBase::SharedPtr, 0>{}, std::array<Fixed::WaitableEntry, 0>{});
  own_guard->trigger();
  check("one of fixed size", fixed.wait(1s).kind() == Kind::Ready);
  rclcpp::ThreadSafeWaitSet safe;
  safe.add_timer(timer);
  check("one for several threads", safe.wait(1s).kind() == Kind::Ready);
  rclcpp::shutdown();
}
