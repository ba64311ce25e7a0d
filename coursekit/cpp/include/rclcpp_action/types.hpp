// What clients and servers of actions have in common.
#pragma once
#include <array>
#include <functional>
#include <sstream>
#include <string>

#include "action_msgs/msg/goal_info.hpp"
#include "action_msgs/msg/goal_status.hpp"
#include "action_msgs/srv/cancel_goal.hpp"
#include "rcl_action/types.h"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp_action
{
using GoalUUID = std::array<uint8_t, 16>;
using GoalStatus = action_msgs::msg::GoalStatus;
using GoalInfo = action_msgs::msg::GoalInfo;

inline std::string to_string(const GoalUUID & goal_id)
{
  std::ostringstream text;
  text << std::hex;
  for (auto byte : goal_id) {
    text << static_cast<int>(byte);
  }
  return text.str();
}
inline void convert(const GoalUUID & goal_id, GoalInfo * goal_info)
{
  std::copy(goal_id.begin(), goal_id.end(), goal_info->goal_id.uuid.begin());
}
inline void convert(const GoalInfo & goal_info, GoalUUID * goal_id)
{
  std::copy(goal_info.goal_id.uuid.begin(), goal_info.goal_id.uuid.end(), goal_id->begin());
}
/// How the states of goals travel: who comes late gets the last ones.
class DefaultActionStatusQoS : public rclcpp::QoS
{
public:
  DefaultActionStatusQoS()
  : rclcpp::QoS(1) {reliable().transient_local();}
};
inline std::string bytes_of(const GoalUUID & goal_id) {return std::string(goal_id.begin(), goal_id.end());}
inline GoalUUID goal_id_of(const std::string & bytes)
{
  GoalUUID goal_id{};
  std::copy_n(bytes.begin(), std::min(bytes.size(), goal_id.size()), goal_id.begin());
  return goal_id;
}

namespace exceptions
{
class UnknownGoalHandleError : public std::invalid_argument
{
public:
  UnknownGoalHandleError()
  : std::invalid_argument("Goal handle is not known to this client.") {}
};
class UnawareGoalHandleError : public std::runtime_error
{
public:
  explicit UnawareGoalHandleError(const std::string & text = "Goal handle is not tracking the goal result.")
  : std::runtime_error(text) {}
};
}  // namespace exceptions
}  // namespace rclcpp_action

namespace std
{
/// Numbers of goals are keys of maps, as with Humble's header.
template<>
struct hash<rclcpp_action::GoalUUID>
{
  size_t operator()(const rclcpp_action::GoalUUID & goal_id) const noexcept
  {
    return hash<string>()(rclcpp_action::bytes_of(goal_id));
  }
};
}  // namespace std
