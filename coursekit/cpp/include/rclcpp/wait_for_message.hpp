// Wait for one message, whether or not an executor serves the node.
#pragma once
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
/// Whether a message came on the topic within the time; without one, whenever it comes.
template<class T, class Rep = int64_t, class Period = std::milli>
bool wait_for_message(
  T & out, std::shared_ptr<Node> node, const std::string & topic,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
{
  bool came = false;
  SubscriptionOptions options;
  options.callback_group = node->create_callback_group(CallbackGroupType::MutuallyExclusive, false);
  auto subscription = node->create_subscription<T>(
    topic, QoS(1), [&](const T & message) {
      if (!came) {
        out = message;
        came = true;
      }
    }, options);
  executors::SingleThreadedExecutor executor;
  executor.add_callback_group(options.callback_group, node->get_node_base_interface());
  Clock clock(RCL_STEADY_TIME);
  bool endless = time_to_wait.count() < 0;
  Time end = clock.now() + Duration(endless ? std::chrono::nanoseconds(0) : std::chrono::duration_cast<std::chrono::nanoseconds>(time_to_wait));
  while (!came && ok() && (endless || clock.now() < end)) {
    executor.spin_once(std::chrono::nanoseconds(endless ? -1 : (end - clock.now()).nanoseconds()));
  }
  executor.remove_callback_group(options.callback_group);
  return came;
}
/// The same with a subscription that is there already.
template<class T, class Rep = int64_t, class Period = std::milli>
bool wait_for_message(
  T & out, std::shared_ptr<Subscription<T>> subscription, std::shared_ptr<Context>,
  std::chrono::duration<Rep, Period> time_to_wait = std::chrono::duration<Rep, Period>(-1))
{
  WaitSet set;
  set.add_subscription(subscription);
  MessageInfo info;
  return set.wait(time_to_wait).kind() == WaitResultKind::Ready && subscription->take(out, info);
}
}  // namespace rclcpp
