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
  explicit Transition(uint8_t id, const std::string & label = "")
  : id_(id), label_(label) {}
  Transition(uint8_t id, const std::string & label, State && start, State && goal)
  : id_(id), label_(label), start_(std::move(start)), goal_(std::move(goal)) {}
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
