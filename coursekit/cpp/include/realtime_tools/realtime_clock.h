// The time for a thread that must not wait: here reading a clock takes no waiting.
#pragma once
#include "rclcpp/rclcpp.hpp"

namespace realtime_tools
{
class RealtimeClock
{
public:
  RealtimeClock() = default;
  explicit RealtimeClock(rclcpp::Clock::SharedPtr clock)
  : clock_(std::move(clock)) {}
  rclcpp::Time now(const rclcpp::Time & realtime_time)
  {
    return clock_ ? clock_->now() : realtime_time;
  }

private:
  rclcpp::Clock::SharedPtr clock_;
};
}  // namespace realtime_tools
