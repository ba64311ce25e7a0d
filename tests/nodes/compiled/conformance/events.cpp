// Events of publishers and subscriptions as waitables: a program waits for them itself.
#include "check.hpp"
#include "std_msgs/msg/int32.hpp"

using std_msgs::msg::Int32;
using Kind = rclcpp::WaitResultKind;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("eventful");
  std::vector<int> missed;
  rclcpp::SubscriptionOptions hearing;
  hearing.event_callbacks.deadline_callback = [&](rclcpp::QOSDeadlineRequestedInfo & info) {
      missed.push_back(info.total_count_change);
    };
  auto subscription = node->create_subscription<Int32>(
    "number", rclcpp::QoS(3).deadline(50ms), [](const Int32 &) {}, hearing);
  auto & handlers = subscription->get_event_handlers();
  equal("the program's callback and the usual warning", handlers.size(), 2u);
  check("by the kind of event", handlers.count(RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED) == 1);
  auto deadline = handlers.at(RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED);
  equal("a handler has one event", deadline->get_number_of_ready_events(), 1u);

  rclcpp::SubscriptionWaitSetMask events_only;
  events_only.include_subscription = false;
  rclcpp::WaitSet set;
  set.add_subscription(subscription, events_only);
  equal("a mask leaves the messages out", set.get_rcl_wait_set().size_of_subscriptions, 0u);
  check("nothing was promised yet", set.wait(10ms).kind() == Kind::Timeout);
  auto publisher = node->create_publisher<Int32>("number", rclcpp::QoS(3).deadline(50ms));
  publisher->publish(Int32().set__data(1));
  check("a missed deadline ends the wait", set.wait(1s).kind() == Kind::Ready);
  equal("both events were waited for", set.get_rcl_wait_set().size_of_events, 2u);
  auto state = set.get_rcl_wait_set();
  check("the handler is ready", deadline->is_ready(&state));
  auto data = deadline->take_data();
  deadline->execute(data);
  check("its callback is told", missed == std::vector<int>({1}));
  set.remove_subscription(subscription, events_only);
  check("it is waited for no more", set.wait(10ms).kind() == Kind::Empty);
  set.add_waitable(deadline, subscription);
  throws<std::runtime_error>("an event is in one set", [&] {rclcpp::WaitSet().add_waitable(deadline);});
  check("an event is a waitable as others", set.wait(1s).kind() == Kind::Ready);

  // with its messages
  rclcpp::WaitSet whole;
  auto other = node->create_subscription<Int32>("number", 3, [](const Int32 &) {});
  whole.add_subscription(other);
  publisher->publish(Int32().set__data(2));
  check("messages come as before", whole.wait(1s).kind() == Kind::Ready && whole.get_rcl_wait_set().subscriptions[0]);
  whole.remove_subscription(other);
  check("with its events it goes", whole.wait(10ms).kind() == Kind::Empty);

  // publishers
  std::atomic<int> told{0};
  rclcpp::PublisherOptions silent;
  silent.use_default_callbacks = false;
  equal("no events", node->create_publisher<Int32>("silent", 1, silent)->get_event_handlers().size(), 0u);
  auto offered = node->create_publisher<Int32>("offered", rclcpp::QoS(1).best_effort());
  auto mismatch = offered->get_event_handlers().at(RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS);
  mismatch->set_on_ready_callback([&](size_t count, int) {told += static_cast<int>(count);});
  throws<std::invalid_argument>("no empty callback", [&] {mismatch->set_on_ready_callback(nullptr);});
  auto asks = node->create_subscription<Int32>("offered", rclcpp::QoS(1).reliable(), [](const Int32 &) {});
  spin_until(node, [&] {return told > 0;});
  equal("a listener hears of a mismatch at once", told.load(), 1);
  mismatch->clear_on_ready_callback();
  rclcpp::shutdown();
}
