// Points in time, in nanoseconds, of one of three kinds of clock.
#pragma once
#include "builtin_interfaces/msg/time.hpp"
#include "rcl/time.h"
#include "rclcpp/duration.hpp"

namespace rclcpp
{
class Time
{
public:
  Time(int32_t seconds, uint32_t nanoseconds, rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : ns_(seconds * 1000000000LL + nanoseconds), type_(type) {check(seconds);}
  explicit Time(int64_t nanoseconds = 0, rcl_clock_type_t type = RCL_SYSTEM_TIME)
  : ns_(nanoseconds), type_(type) {}
  explicit Time(const rcl_time_point_t & point)
  : ns_(point.nanoseconds), type_(point.clock_type) {}
  Time(const builtin_interfaces::msg::Time & message, rcl_clock_type_t type = RCL_ROS_TIME)  // NOLINT
  : ns_(message.sec * 1000000000LL + message.nanosec), type_(type) {check(message.sec);}

  static Time max(rcl_clock_type_t type = RCL_SYSTEM_TIME) {return Time(std::numeric_limits<int32_t>::max(), 999999999, type);}
  rcl_time_point_value_t nanoseconds() const {return ns_;}
  double seconds() const {return ns_ / 1e9;}
  rcl_clock_type_t get_clock_type() const {return type_;}
  Time & operator=(const builtin_interfaces::msg::Time & message) {return *this = Time(message);}
  operator builtin_interfaces::msg::Time() const
  {
    builtin_interfaces::msg::Time message;
    int64_t rest = ns_ % 1000000000;
    message.sec = static_cast<int32_t>(ns_ / 1000000000 - (rest < 0));
    message.nanosec = static_cast<uint32_t>(rest < 0 ? rest + 1000000000 : rest);
    return message;
  }

  Time operator+(const Duration & duration) const {return Time(detail::added(ns_, duration.nanoseconds(), "addition leads"), type_);}
  Time operator-(const Duration & duration) const {return Time(detail::subtracted(ns_, duration.nanoseconds()), type_);}
  Duration operator-(const Time & other) const
  {
    check_same(other, "can't subtract times with different time sources [");
    return Duration::from_nanoseconds(detail::subtracted(ns_, other.ns_));
  }
  Time & operator+=(const Duration & duration) {return *this = *this + duration;}
  Time & operator-=(const Duration & duration) {return *this = *this - duration;}
  bool operator==(const Time & other) const {return compared(other) == 0;}
  bool operator!=(const Time & other) const {return compared(other) != 0;}
  bool operator<(const Time & other) const {return compared(other) < 0;}
  bool operator<=(const Time & other) const {return compared(other) <= 0;}
  bool operator>(const Time & other) const {return compared(other) > 0;}
  bool operator>=(const Time & other) const {return compared(other) >= 0;}

private:
  static void check(int32_t seconds)
  {
    if (seconds < 0) {
      throw std::runtime_error("cannot store a negative time point in rclcpp::Time");
    }
  }
  int compared(const Time & other) const
  {
    if (type_ != other.type_) {
      throw std::runtime_error("can't compare times with different time sources");
    }
    return ns_ < other.ns_ ? -1 : ns_ > other.ns_;
  }
  void check_same(const Time & other, const char * what) const
  {
    if (type_ != other.type_) {
      throw std::runtime_error(what + std::to_string(type_) + " != " + std::to_string(other.type_) + "]");
    }
  }
  int64_t ns_;
  rcl_clock_type_t type_;
};
inline Time operator+(const Duration & duration, const Time & time) {return time + duration;}
}  // namespace rclcpp
