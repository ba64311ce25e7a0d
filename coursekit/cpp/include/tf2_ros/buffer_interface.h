// rclcpp's times as tf2's, and what all buffers have.
#pragma once
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2/convert.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2_ros
{
inline tf2::TimePoint fromRclcpp(const rclcpp::Time & time) {return tf2::TimePoint(std::chrono::nanoseconds(time.nanoseconds()));}
inline tf2::Duration fromRclcpp(const rclcpp::Duration & duration) {return tf2::Duration(duration.nanoseconds());}
inline rclcpp::Time toRclcpp(const tf2::TimePoint & time) {return rclcpp::Time(time.time_since_epoch().count(), RCL_ROS_TIME);}
inline rclcpp::Duration toRclcpp(const tf2::Duration & duration) {return rclcpp::Duration(duration);}
inline tf2::TimePoint fromMsg(const builtin_interfaces::msg::Time & time)
{
  return tf2::TimePoint(std::chrono::seconds(time.sec) + std::chrono::nanoseconds(time.nanosec));
}
inline builtin_interfaces::msg::Time toMsg(const tf2::TimePoint & time) {return toRclcpp(time);}
inline builtin_interfaces::msg::Duration toMsg(const tf2::Duration & duration) {return toRclcpp(duration);}
inline tf2::Duration fromMsg(const builtin_interfaces::msg::Duration & duration)
{
  return tf2::Duration(std::chrono::seconds(duration.sec) + std::chrono::nanoseconds(duration.nanosec));
}
inline double timeToSec(const builtin_interfaces::msg::Time & time) {return tf2::timeToSec(fromMsg(time));}

class BufferInterface
{
public:
  virtual ~BufferInterface() = default;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout) const = 0;
  virtual geometry_msgs::msg::TransformStamped lookupTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
    const std::string & fixed, const tf2::Duration timeout) const = 0;
  virtual bool canTransform(
    const std::string & target, const std::string & source, const tf2::TimePoint & time, const tf2::Duration timeout,
    std::string * why_not) const = 0;
  virtual bool canTransform(
    const std::string & target, const tf2::TimePoint & target_time, const std::string & source, const tf2::TimePoint & source_time,
    const std::string & fixed, const tf2::Duration timeout, std::string * why_not) const = 0;

  template<class T>
  T transform(const T & in, const std::string & target, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    return transform(in, out, target, timeout);
  }
  template<class T>
  T & transform(const T & in, T & out, const std::string & target, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(in, out, lookupTransform(target, tf2::getFrameId(in), tf2::getTimestamp(in), timeout));
    return out;
  }
  /// The same, with what comes out as another type.
  template<class A, class B>
  B & transform(const A & in, B & out, const std::string & target, tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::convert(transform(in, target, timeout), out);
    return out;
  }
  /// As it is seen from a target at another time, by a frame that did not move in between.
  template<class T>
  T & transform(
    const T & in, T & out, const std::string & target, const tf2::TimePoint & target_time, const std::string & fixed,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::doTransform(
      in, out, lookupTransform(target, target_time, tf2::getFrameId(in), tf2::getTimestamp(in), fixed, timeout));
    return out;
  }
  template<class T>
  T transform(
    const T & in, const std::string & target, const tf2::TimePoint & target_time, const std::string & fixed,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    T out;
    return transform(in, out, target, target_time, fixed, timeout);
  }
  template<class A, class B>
  B & transform(
    const A & in, B & out, const std::string & target, const tf2::TimePoint & target_time, const std::string & fixed,
    tf2::Duration timeout = tf2::Duration::zero()) const
  {
    tf2::convert(transform(in, target, target_time, fixed, timeout), out);
    return out;
  }
};
}  // namespace tf2_ros
