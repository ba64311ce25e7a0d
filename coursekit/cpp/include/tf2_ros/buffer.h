// Transforms of the last seconds: a buffer of the session's, asked over the link.
#pragma once
#include "coursekit/entity.hpp"
#include "tf2_ros/buffer_interface.h"

namespace tf2_ros
{
class Buffer : public BufferInterface, public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Buffer)
  explicit Buffer(
    rclcpp::Clock::SharedPtr clock, tf2::Duration cache_time = tf2::BUFFER_CORE_DEFAULT_CACHE_TIME,
    rclcpp::Node::SharedPtr node = nullptr);

  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time,
    const tf2::Duration timeout = tf2::Duration::zero()) const override;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    return lookupTransform(target, source, fromRclcpp(time), fromRclcpp(timeout));
  }
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source,
    const tf2::TimePoint & source_time, const std::string & fixed, const tf2::Duration timeout = tf2::Duration::zero()) const;
  geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const rclcpp::Time & target_time, const std::string & source, const rclcpp::Time & source_time,
    const std::string & fixed, const rclcpp::Duration timeout = rclcpp::Duration(0, 0)) const
  {
    return lookupTransform(target, fromRclcpp(target_time), source, fromRclcpp(source_time), fixed, fromRclcpp(timeout));
  }

  bool canTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time,
    const tf2::Duration timeout = tf2::Duration::zero(), std::string * why_not = nullptr) const;
  bool canTransform(
    const std::string & target, const std::string & source, const rclcpp::Time & time,
    const rclcpp::Duration timeout = rclcpp::Duration(0, 0), std::string * why_not = nullptr) const
  {
    return canTransform(target, source, fromRclcpp(time), fromRclcpp(timeout), why_not);
  }

  bool setTransform(const geometry_msgs::msg::TransformStamped & transform, const std::string & authority, bool is_static = false);
  void clear();
  std::string allFramesAsString() const;
  std::string allFramesAsYAML() const;
  std::vector<std::string> getAllFrameNames() const;
  bool setUsingDedicatedThread(bool) {return true;}
  template<class T>
  void setCreateTimerInterface(const T &) {}
};
}  // namespace tf2_ros
