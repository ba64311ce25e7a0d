// Distances between poses, and along paths.
#pragma once
#include <cmath>
#include <limits>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/pose.hpp"
#include "geometry_msgs/msg/pose2_d.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "geometry_msgs/msg/quaternion.hpp"
#include "nav_msgs/msg/path.hpp"
#include "tf2/LinearMath/Quaternion.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace nav2_util
{
namespace geometry_utils
{
inline geometry_msgs::msg::Quaternion orientationAroundZAxis(double angle)
{
  tf2::Quaternion turned;
  turned.setRPY(0, 0, angle);
  return tf2::toMsg(turned);
}

/// In the plane, unless `is_3d`.
inline double euclidean_distance(
  const geometry_msgs::msg::Point & pos1, const geometry_msgs::msg::Point & pos2, const bool is_3d = false)
{
  return std::hypot(pos1.x - pos2.x, pos1.y - pos2.y, is_3d ? pos1.z - pos2.z : 0.0);
}
inline double euclidean_distance(
  const geometry_msgs::msg::Pose & pos1, const geometry_msgs::msg::Pose & pos2, const bool is_3d = false)
{
  return euclidean_distance(pos1.position, pos2.position, is_3d);
}
inline double euclidean_distance(
  const geometry_msgs::msg::PoseStamped & pos1, const geometry_msgs::msg::PoseStamped & pos2, const bool is_3d = false)
{
  return euclidean_distance(pos1.pose, pos2.pose, is_3d);
}
inline double euclidean_distance(const geometry_msgs::msg::Pose2D & pos1, const geometry_msgs::msg::Pose2D & pos2)
{
  return std::hypot(pos1.x - pos2.x, pos1.y - pos2.y);
}

/// The element with the least value of a function.
template<typename Iter, typename Getter>
inline Iter min_by(Iter begin, Iter end, Getter getCompareVal)
{
  Iter least = begin;
  for (Iter one = begin; one != end; ++one) {
    if (getCompareVal(*one) < getCompareVal(*least)) {
      least = one;
    }
  }
  return least;
}

/// The first pose that is farther along a path than a distance; the end if none is.
template<typename Iter>
inline Iter first_after_integrated_distance(Iter begin, Iter end, double distance)
{
  if (begin == end) {
    return end;
  }
  double gone = 0.0;
  for (Iter one = begin; one + 1 != end; ++one) {
    gone += euclidean_distance(*one, *(one + 1));
    if (gone > distance) {
      return one + 1;
    }
  }
  return end;
}

inline double calculate_path_length(const nav_msgs::msg::Path & path, size_t start_index = 0)
{
  double length = 0.0;
  for (size_t i = start_index; i + 1 < path.poses.size(); ++i) {
    length += euclidean_distance(path.poses[i], path.poses[i + 1]);
  }
  return length;
}
}  // namespace geometry_utils
}  // namespace nav2_util
