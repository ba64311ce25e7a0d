// A state of a managed node.
#pragma once
#include <cstdint>
#include <stdexcept>
#include <string>

#include "lifecycle_msgs/msg/state.hpp"
#include "rclcpp_lifecycle/visibility_control.h"

namespace rclcpp_lifecycle
{
class State
{
public:
  State()
  : State(lifecycle_msgs::msg::State::PRIMARY_STATE_UNKNOWN, "unknown") {}
  State(uint8_t id, const std::string & label)
  : id_(id), label_(label)
  {
    if (label.empty()) {
      throw std::runtime_error("Lifecycle State cannot have an empty label.");
    }
  }
  virtual ~State() = default;
  uint8_t id() const {return id_;}
  std::string label() const {return label_;}

private:
  uint8_t id_;
  std::string label_;
};
}  // namespace rclcpp_lifecycle
