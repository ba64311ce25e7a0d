// What a buffer has its timers of: a node's, or a program's own.
#pragma once
#include <functional>
#include <memory>
#include <stdexcept>

#include "rclcpp/clock.hpp"
#include "tf2/time.h"

namespace tf2_ros
{
using TimerHandle = uint64_t;
using TimerCallbackType = std::function<void (const TimerHandle &)>;

class CreateTimerInterfaceException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class InvalidTimerHandleException : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

class CreateTimerInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(CreateTimerInterface)
  CreateTimerInterface() = default;
  virtual ~CreateTimerInterface() = default;
  /// A timer that calls back each period; its number.
  virtual TimerHandle createTimer(rclcpp::Clock::SharedPtr clock, const tf2::Duration & period, TimerCallbackType callback) = 0;
  /// Stop a timer, start it anew, stop and forget it; InvalidTimerHandleException where there is none of that number.
  virtual void cancel(const TimerHandle & timer_handle) = 0;
  virtual void reset(const TimerHandle & timer_handle) = 0;
  virtual void remove(const TimerHandle & timer_handle) = 0;
};
}  // namespace tf2_ros
