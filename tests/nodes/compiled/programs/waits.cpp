// Wait sets, guard conditions, messages as bytes, lent messages, adapted types.
#include <iostream>

#include "rclcpp/guard_condition.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp/serialization.hpp"
#include "rclcpp/wait_set.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"
using namespace std::chrono_literals;
using std_msgs::msg::Int32;
using std_msgs::msg::String;

template<>
struct rclcpp::TypeAdapter<std::string, String>
{
  using is_specialized = std::true_type;
  using custom_type = std::string;
  using ros_message_type = String;
  static void convert_to_ros_message(const custom_type & from, ros_message_type & to) {to.data = from;}
  static void convert_to_custom(const ros_message_type & from, custom_type & to) {to = from.data;}
};
using Adapted = rclcpp::TypeAdapter<std::string, String>;

// Calls back for all messages that wait: spin_some takes one of each subscription, as in Humble.
static void take_all(rclcpp::Node::SharedPtr node)
{
  rclcpp::executors::SingleThreadedExecutor executor;
  executor.add_node(node);
  executor.spin_all(std::chrono::nanoseconds(0));
  executor.remove_node(node);
}

static void wait_sets(rclcpp::Node::SharedPtr node)
{
  auto heard = [](const String & message) {std::cout << "called with " << message.data << std::endl;};
  auto first = node->create_subscription<String>("first", 10, heard);
  auto second = node->create_subscription<String>("second", 10, heard);
  auto publisher = node->create_publisher<String>("second", 10);
  auto guard = std::make_shared<rclcpp::GuardCondition>();
  auto timer = node->create_wall_timer(300ms, [] {std::cout << "timer's callback" << std::endl;});
  rclcpp::WaitSet set({{{first}, {second}}}, {guard}, {timer});
  std::cout << (set.wait(100ms).kind() == rclcpp::WaitResultKind::Timeout)
            << (rclcpp::WaitSet().wait(1s).kind() == rclcpp::WaitResultKind::Empty);
  String message;
  message.data = "hello";
  publisher->publish(message);
  auto result = set.wait(1s);
  auto & state = result.get_wait_set().get_rcl_wait_set();
  std::cout << (result.kind() == rclcpp::WaitResultKind::Ready) << (state.subscriptions[0] != nullptr)
            << (state.subscriptions[1] != nullptr)
            << (state.guard_conditions[0] != nullptr) << state.size_of_subscriptions << state.size_of_timers << std::endl;
  rclcpp::MessageInfo info;
  String taken;
  if (second->take(taken, info)) {
    std::shared_ptr<void> erased = std::make_shared<String>(taken);
    second->handle_message(erased, info);
  }
  std::cout << second->take(taken, info) << std::endl;
  std::thread other([guard] {
      std::this_thread::sleep_for(50ms);
      guard->trigger();
    });
  auto before = node->now();
  auto woken = set.wait();
  std::cout << (set.get_rcl_wait_set().guard_conditions[0] != nullptr) << " after "
            << (node->now() - before).nanoseconds() / 1000000;
  other.join();
  woken = set.wait();
  std::cout << " " << (set.get_rcl_wait_set().timers[0] != nullptr)
            << (set.get_rcl_wait_set().guard_conditions[0] != nullptr)
            << timer->is_ready() << timer->call() << timer->is_ready() << std::endl;
  timer->execute_callback();
  timer->cancel();
  std::cout << timer->call();
  try {
    set.add_guard_condition(guard);
  } catch (const std::runtime_error & error) {
    std::cout << error.what();
  }
  set.remove_guard_condition(guard);
  rclcpp::StaticWaitSet<1, 1> fixed({{{first}}}, {{guard}});
  std::cout << (fixed.wait(0s).kind() == rclcpp::WaitResultKind::Timeout) << std::endl;
}
static void bytes(rclcpp::Node::SharedPtr node)
{
  rclcpp::Serialization<String> serialization;
  rclcpp::SerializedMessage packed;
  String message, again;
  message.data = "abc";
  serialization.serialize_message(&message, &packed);
  serialization.deserialize_message(&packed, &again);
  std::cout << packed.size() << again.data << int(packed.get_rcl_serialized_message().buffer[8]);
  auto publisher = node->create_publisher<String>("bytes", 10);
  auto generic = node->create_generic_publisher("bytes", "std_msgs/msg/String", 10);
  auto typed = node->create_subscription<String>("bytes", 10, [](String::UniquePtr m) {std::cout << " typed " << m->data;});
  auto raw = node->create_generic_subscription(
    "bytes", "std_msgs/msg/String", 10, [](std::shared_ptr<rclcpp::SerializedMessage> m) {
      std::cout << " raw " << m->size();
    });
  auto also = node->create_subscription<String>(
    "bytes", 10, [](std::shared_ptr<rclcpp::SerializedMessage> m) {std::cout << " also " << m->size();});
  publisher->publish(packed);
  generic->publish(packed);
  auto lent = publisher->borrow_loaned_message();
  lent.get().data = "lent";
  publisher->publish(std::move(lent));
  take_all(node);
  std::cout << std::endl;
}
static void adapters(rclcpp::Node::SharedPtr node)
{
  auto publisher = node->create_publisher<Adapted>("adapted", 10);
  auto custom = node->create_subscription<Adapted>(
    "adapted", 10, [](const std::string & text) {std::cout << "custom " << text;});
  auto plain = node->create_subscription<String>("adapted", 10, [](const String & m) {std::cout << " plain " << m.data;});
  publisher->publish(std::string("one"));
  publisher->publish(std::make_unique<std::string>("two"));
  String message;
  message.data = "three";
  publisher->publish(message);
  take_all(node);
  std::cout << std::endl;
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("waiter");
  wait_sets(node);
  bytes(node);
  adapters(node);
  rclcpp::WaitSet set({}, {std::make_shared<rclcpp::GuardCondition>()});
  std::cout << "waits" << std::endl;
  std::cout << (set.wait().kind() == rclcpp::WaitResultKind::Timeout) << rclcpp::ok() << std::endl;
  rclcpp::shutdown();
}
