// Fills a buffer with what is broadcast, in a thread of the session's.
#pragma once
#include "tf2_ros/buffer.h"
#include "tf2_ros/qos.hpp"

namespace tf2_ros
{
class TransformListener : public coursekit::Entity
{
public:
  using SharedPtr = std::shared_ptr<TransformListener>;
  explicit TransformListener(tf2::BufferCore & buffer, bool = true, bool static_only = false) {listen(buffer, static_only);}
  template<class N, class = std::enable_if_t<!std::is_same_v<std::decay_t<N>, bool>>>
  TransformListener(
    tf2::BufferCore & buffer, N &&, bool = true, const rclcpp::QoS & = DynamicListenerQoS(), const rclcpp::QoS & = StaticListenerQoS(),
    bool static_only = false)
  {
    listen(buffer, static_only);
  }

  /// The options are those of subscriptions in the node; here the session hears in its stead.
  template<class N>
  TransformListener(
    tf2::BufferCore & buffer, N &&, bool, const rclcpp::QoS &, const rclcpp::QoS &, const rclcpp::SubscriptionOptions &,
    const rclcpp::SubscriptionOptions & = {})
  {
    listen(buffer, false);
  }

private:
  void listen(tf2::BufferCore & buffer, bool static_only);
};
}  // namespace tf2_ros
