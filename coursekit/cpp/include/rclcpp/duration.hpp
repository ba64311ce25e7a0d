// Durations, in nanoseconds.
#pragma once
#include <chrono>
#include <limits>
#include <stdexcept>

#include "builtin_interfaces/msg/duration.hpp"
#include "rcl/time.h"
#include "rmw/types.h"

namespace rclcpp
{
namespace detail
{
/// A sum; std::overflow_error or std::underflow_error where it does not fit, with what was done in the text.
inline int64_t added(int64_t left, int64_t right, const char * what)
{
  int64_t sum;
  if (!__builtin_add_overflow(left, right, &sum)) {
    return sum;
  }
  if (right > 0) {
    throw std::overflow_error(std::string(what) + " to int64_t overflow");
  }
  throw std::underflow_error(std::string(what) + " to int64_t underflow");
}
inline int64_t subtracted(int64_t left, int64_t right)
{
  int64_t rest;
  if (!__builtin_sub_overflow(left, right, &rest)) {
    return rest;
  }
  if (right < 0) {
    throw std::overflow_error("time subtraction leads to int64_t overflow");
  }
  throw std::underflow_error("time subtraction leads to int64_t underflow");
}
}  // namespace detail

class Duration
{
public:
  Duration() = default;
  Duration(int32_t seconds, uint32_t nanoseconds)
  : ns_(seconds * 1000000000LL + nanoseconds) {}
  explicit Duration(std::chrono::nanoseconds duration)
  : ns_(duration.count()) {}
  template<class Rep, class Period>
  Duration(const std::chrono::duration<Rep, Period> & duration)  // NOLINT: implicit, as upstream's
  : ns_(std::chrono::duration_cast<std::chrono::nanoseconds>(duration).count()) {}
  Duration(const builtin_interfaces::msg::Duration & message)  // NOLINT
  : ns_(message.sec * 1000000000LL + message.nanosec) {}
  explicit Duration(const rcl_duration_t & duration)
  : ns_(duration.nanoseconds) {}

  static Duration from_seconds(double seconds) {return from_nanoseconds(static_cast<int64_t>(seconds * 1e9));}
  static Duration from_nanoseconds(rcl_duration_value_t nanoseconds)
  {
    Duration made;
    made.ns_ = nanoseconds;
    return made;
  }
  static Duration from_rmw_time(rmw_time_t time)
  {
    constexpr int64_t most = std::numeric_limits<int64_t>::max();
    if (time.sec > static_cast<uint64_t>(most / 1000000000)) {
      return from_nanoseconds(most);
    }
    return from_nanoseconds(static_cast<int64_t>(time.sec * 1000000000 + time.nsec));
  }
  static Duration max() {return from_nanoseconds(std::numeric_limits<int64_t>::max());}

  rcl_duration_value_t nanoseconds() const {return ns_;}
  double seconds() const {return ns_ / 1e9;}
  template<class D>
  D to_chrono() const {return std::chrono::duration_cast<D>(std::chrono::nanoseconds(ns_));}
  rmw_time_t to_rmw_time() const
  {
    if (ns_ < 0) {
      throw std::runtime_error("rmw_time_t cannot be negative");
    }
    return {static_cast<uint64_t>(ns_ / 1000000000), static_cast<uint64_t>(ns_ % 1000000000)};
  }
  operator builtin_interfaces::msg::Duration() const
  {
    builtin_interfaces::msg::Duration message;
    int64_t rest = ns_ % 1000000000;
    message.sec = static_cast<int32_t>(ns_ / 1000000000 - (rest < 0));
    message.nanosec = static_cast<uint32_t>(rest < 0 ? rest + 1000000000 : rest);
    return message;
  }

  Duration operator+(const Duration & other) const {return from_nanoseconds(detail::added(ns_, other.ns_, "addition leads"));}
  Duration operator-(const Duration & other) const {return from_nanoseconds(detail::added(ns_, -other.ns_, "duration subtraction leads"));}
  Duration operator*(double factor) const
  {
    if (!(factor > -1e300 && factor < 1e300)) {
      throw std::runtime_error("abnormal scale in rclcpp::Duration");
    }
    long double scaled = static_cast<long double>(ns_) * factor;
    if (scaled > std::numeric_limits<int64_t>::max()) {
      throw std::overflow_error("duration scaling leads to int64_t overflow");
    }
    if (scaled < std::numeric_limits<int64_t>::min()) {
      throw std::underflow_error("duration scaling leads to int64_t underflow");
    }
    return from_nanoseconds(static_cast<int64_t>(scaled));
  }
  Duration operator-() const {return from_nanoseconds(-ns_);}
  Duration & operator+=(const Duration & other) {return *this = *this + other;}
  Duration & operator-=(const Duration & other) {return *this = *this - other;}
  Duration & operator*=(double factor) {return *this = *this * factor;}
  bool operator==(const Duration & other) const {return ns_ == other.ns_;}
  bool operator!=(const Duration & other) const {return ns_ != other.ns_;}
  bool operator<(const Duration & other) const {return ns_ < other.ns_;}
  bool operator<=(const Duration & other) const {return ns_ <= other.ns_;}
  bool operator>(const Duration & other) const {return ns_ > other.ns_;}
  bool operator>=(const Duration & other) const {return ns_ >= other.ns_;}

private:
  int64_t ns_ = 0;
};
}  // namespace rclcpp
