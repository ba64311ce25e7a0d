// How a tree's file writes poses, and times in milliseconds.
#pragma once
#include <chrono>
#include <stdexcept>
#include <string>
#include <vector>

#include "behaviortree_cpp_v3/basic_types.h"
#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "rclcpp/time.hpp"

namespace nav2_behavior_tree
{
/// The parts of a text between semicolons: so many, or std::runtime_error.
inline std::vector<BT::StringView> parts_of(BT::StringView text, size_t count, const char * what)
{
  auto parts = BT::splitString(text, ';');
  if (parts.size() != count) {
    throw std::runtime_error(std::string("invalid number of fields for ") + what + " attribute)");
  }
  return parts;
}
}  // namespace nav2_behavior_tree

namespace BT
{
/// x;y;z
template<>
inline geometry_msgs::msg::Point convertFromString(StringView text)
{
  const auto parts = nav2_behavior_tree::parts_of(text, 3, "point");
  geometry_msgs::msg::Point point;
  point.x = convertFromString<double>(parts[0]);
  point.y = convertFromString<double>(parts[1]);
  point.z = convertFromString<double>(parts[2]);
  return point;
}
/// x;y;z;w
template<>
inline geometry_msgs::msg::Quaternion convertFromString(StringView text)
{
  const auto parts = nav2_behavior_tree::parts_of(text, 4, "orientation");
  geometry_msgs::msg::Quaternion orientation;
  orientation.x = convertFromString<double>(parts[0]);
  orientation.y = convertFromString<double>(parts[1]);
  orientation.z = convertFromString<double>(parts[2]);
  orientation.w = convertFromString<double>(parts[3]);
  return orientation;
}
/// nanoseconds;frame;x;y;z;x;y;z;w
template<>
inline geometry_msgs::msg::PoseStamped convertFromString(StringView text)
{
  const auto parts = nav2_behavior_tree::parts_of(text, 9, "PoseStamped");
  const size_t position = parts[0].size() + parts[1].size() + 2;
  const size_t orientation = position + parts[2].size() + parts[3].size() + parts[4].size() + 3;
  geometry_msgs::msg::PoseStamped pose;
  pose.header.stamp = rclcpp::Time(static_cast<int64_t>(std::stoll(std::string(parts[0]))));
  pose.header.frame_id = std::string(parts[1]);
  pose.pose.position = convertFromString<geometry_msgs::msg::Point>(text.substr(position, orientation - position - 1));
  pose.pose.orientation = convertFromString<geometry_msgs::msg::Quaternion>(text.substr(orientation));
  return pose;
}
template<>
inline std::chrono::milliseconds convertFromString(StringView text)
{
  return std::chrono::milliseconds(std::stoul(std::string(text)));
}
}  // namespace BT
