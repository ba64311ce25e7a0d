// A way from one state of a managed node to another.
#pragma once
#include <utility>

#include "lifecycle_msgs/msg/transition.hpp"
#include "rclcpp_lifecycle/state.hpp"

namespace rclcpp_lifecycle
{
class Transition
{
public:
  Transition() = delete;
  explicit Transition(
    uint8_t id, const std::string & label = "", rcutils_allocator_t = rcutils_get_default_allocator())
  : id_(id), label_(label) {}
  Transition(
    uint8_t id, const std::string & label, State && start, State && goal,
    rcutils_allocator_t = rcutils_get_default_allocator())
  : id_(id), label_(label), start_(std::move(start)), goal_(std::move(goal)) {}
  explicit Transition(const rcl_lifecycle_transition_t * handle, rcutils_allocator_t = rcutils_get_default_allocator())
  {
    if (!handle) {
      throw std::runtime_error("rcl_lifecycle_transition_handle is null");
    }
    id_ = static_cast<uint8_t>(handle->id);
    label_ = handle->label;
    start_ = handle->start ? State(handle->start) : State();
    goal_ = handle->goal ? State(handle->goal) : State();
  }
  virtual ~Transition() = default;
  uint8_t id() const {return id_;}
  std::string label() const {return label_;}
  State start_state() const {return start_;}
  State goal_state() const {return goal_;}

private:
  uint8_t id_;
  std::string label_;
  State start_, goal_;
};
}  // namespace rclcpp_lifecycle
