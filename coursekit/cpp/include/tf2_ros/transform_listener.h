// Fills a buffer with what is broadcast, in a thread of the session's; one of its own means that a program may wait for transforms.
#pragma once
#include "tf2_ros/buffer.h"
#include "tf2_ros/qos.hpp"

namespace tf2_ros
{
class TransformListener : public coursekit::Entity
{
public:
  using SharedPtr = std::shared_ptr<TransformListener>;
  explicit TransformListener(tf2::BufferCore & buffer, bool spin_thread = true, bool static_only = false)
  {
    listen(buffer, spin_thread, static_only);
  }
  template<class N, class = std::enable_if_t<!std::is_same_v<std::decay_t<N>, bool>>>
  TransformListener(
    tf2::BufferCore & buffer, N &&, bool spin_thread = true, const rclcpp::QoS & = DynamicListenerQoS(),
    const rclcpp::QoS & = StaticListenerQoS(), bool static_only = false)
  {
    listen(buffer, spin_thread, static_only);
  }

  /// The options are those of subscriptions in the node; here the session hears in its stead.
  template<class N>
  TransformListener(
    tf2::BufferCore & buffer, N &&, bool spin_thread, const rclcpp::QoS &, const rclcpp::QoS &, const rclcpp::SubscriptionOptions &,
    const rclcpp::SubscriptionOptions & = {})
  {
    listen(buffer, spin_thread, false);
  }

private:
  void listen(tf2::BufferCore & buffer, bool spin_thread, bool static_only);
};
}  // namespace tf2_ros
