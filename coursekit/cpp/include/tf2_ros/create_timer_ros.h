#pragma once
#include "tf2_ros/buffer.h"

namespace tf2_ros
{
/// What a buffer makes its timers with: a node's.
class CreateTimerROS : public CreateTimerInterface
{
public:
  CreateTimerROS(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base, rclcpp::node_interfaces::NodeTimersInterface::SharedPtr,
    rclcpp::CallbackGroup::SharedPtr group = nullptr)
  : CreateTimerInterface{base, group} {}
};
}  // namespace tf2_ros
