// A state of a managed node.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "lifecycle_msgs/msg/state.hpp"
#include "rcl_lifecycle/data_types.h"
#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle
{
class State
{
public:
  State()
  : State(lifecycle_msgs::msg::State::PRIMARY_STATE_UNKNOWN, "unknown") {}
  State(uint8_t id, const std::string & label, rcutils_allocator_t = rcutils_get_default_allocator())
  : id_(id), label_(label)
  {
    if (label.empty()) {
      throw std::runtime_error("Lifecycle State cannot have an empty label.");
    }
  }
  explicit State(const rcl_lifecycle_state_t * handle, rcutils_allocator_t = rcutils_get_default_allocator())
  {
    if (!handle) {
      throw std::runtime_error("rcl_lifecycle_state_handle is null");
    }
    id_ = handle->id;
    label_ = handle->label;
  }
  virtual ~State() = default;
  uint8_t id() const {return id_;}
  std::string label() const {return label_;}

private:
  uint8_t id_;
  std::string label_;
};
}  // namespace rclcpp_lifecycle
