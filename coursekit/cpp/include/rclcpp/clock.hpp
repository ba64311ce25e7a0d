// Clocks: the system's, a steady one, and ROS time, which follows /clock where a node does.
#pragma once
#include "rclcpp/context.hpp"
#include "rclcpp/time.hpp"

namespace rclcpp
{
class Clock
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Clock)
  explicit Clock(rcl_clock_type_t type = RCL_SYSTEM_TIME, int64_t node = 0)
  : type_(type), node_(node) {}
  Time now() const;
  bool sleep_until(Time until, Context::SharedPtr context = contexts::get_global_default_context());
  bool sleep_for(Duration duration, Context::SharedPtr context = contexts::get_global_default_context());
  bool ros_time_is_active() const;
  rcl_clock_type_t get_clock_type() const noexcept {return type_;}
  /// The node whose time this is, by its number at the session; 0 for none.
  int64_t node() const {return node_;}

private:
  bool simulated() const;
  rcl_clock_type_t type_;
  int64_t node_;
};
}  // namespace rclcpp
