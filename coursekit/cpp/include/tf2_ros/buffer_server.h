// Answers the BufferClients of other programs out of a buffer.
#pragma once
#include "tf2_ros/buffer.h"

namespace tf2_ros
{
/// The action `ns` of tf2_msgs/LookupTransform; what cannot be answered yet is tried every `check_period`.
class BufferServer : public coursekit::Entity
{
public:
  template<class N>
  BufferServer(
    const tf2::BufferCore & buffer, N node, const std::string & ns, tf2::Duration check_period = tf2::durationFromSec(0.01))
  : BufferServer(buffer, *rclcpp::base_of(node), ns, check_period) {}

private:
  BufferServer(
    const tf2::BufferCore & buffer, const rclcpp::node_interfaces::NodeBaseInterface & node, const std::string & ns,
    tf2::Duration check_period);
};
}  // namespace tf2_ros
