// The timers of a node, for a buffer.
#pragma once
#include <mutex>
#include <unordered_map>

#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/create_timer_interface.h"

namespace tf2_ros
{
class CreateTimerROS : public CreateTimerInterface
{
public:
  CreateTimerROS(
    rclcpp::node_interfaces::NodeBaseInterface::SharedPtr node_base,
    rclcpp::node_interfaces::NodeTimersInterface::SharedPtr node_timers,
    rclcpp::CallbackGroup::SharedPtr callback_group = nullptr);
  TimerHandle createTimer(rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback) override;
  void cancel(const TimerHandle & timer_handle) override;
  void reset(const TimerHandle & timer_handle) override;
  void remove(const TimerHandle & timer_handle) override;

private:
  rclcpp::TimerBase::SharedPtr timer_of(TimerHandle timer_handle, const char * where);
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base_;
  rclcpp::node_interfaces::NodeTimersInterface::SharedPtr timers_;
  rclcpp::CallbackGroup::SharedPtr group_;
  std::mutex lock_;
  TimerHandle last_ = 0;
  std::unordered_map<TimerHandle, rclcpp::TimerBase::SharedPtr> made_;
};
}  // namespace tf2_ros
