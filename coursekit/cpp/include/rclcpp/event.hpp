// A flag that is raised when something has happened.
#pragma once
#include <atomic>

#include "rclcpp/macros.hpp"

namespace rclcpp
{
class Event
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Event)
  bool set() {return state_.exchange(true);}
  bool check() {return state_;}
  bool check_and_clear() {return state_.exchange(false);}

private:
  std::atomic<bool> state_{false};
};
}  // namespace rclcpp
