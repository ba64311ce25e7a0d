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
constexpr int64_t MOST_NANOSECONDS = std::numeric_limits<int64_t>::max();
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
inline int64_t subtracted(int64_t left, int64_t right, const char * what = "time subtraction leads")
{
  int64_t rest;
  if (!__builtin_sub_overflow(left, right, &rest)) {
    return rest;
  }
  if (right < 0) {
    throw std::overflow_error(std::string(what) + " to int64_t overflow");
  }
  throw std::underflow_error(std::string(what) + " to int64_t underflow");
}
/// A sum or difference of durations: the least number, which has no opposite, counts as too little.
inline int64_t checked_duration(int64_t nanoseconds, const char * what)
{
  if (nanoseconds < -MOST_NANOSECONDS) {
    throw std::underflow_error(std::string(what) + " to int64_t underflow");
  }
  return nanoseconds;
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
    constexpr uint64_t most = detail::MOST_NANOSECONDS;
    if (time.sec > most / 1000000000 || time.nsec > most - time.sec * 1000000000) {
      return from_nanoseconds(detail::MOST_NANOSECONDS);
    }
    return from_nanoseconds(static_cast<int64_t>(time.sec * 1000000000 + time.nsec));
  }
  /// The longest that a message can tell.
  static Duration max() {return Duration(std::numeric_limits<int32_t>::max(), 999999999);}

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
  /// Where it does not fit it becomes the longest or the most negative that a message can tell.
  operator builtin_interfaces::msg::Duration() const
  {
    builtin_interfaces::msg::Duration message;
    if (ns_ / 1000000000 > std::numeric_limits<int32_t>::max()) {
      message.sec = std::numeric_limits<int32_t>::max();
      message.nanosec = std::numeric_limits<uint32_t>::max();
      return message;
    }
    if (ns_ / 1000000000 <= std::numeric_limits<int32_t>::min()) {
      message.sec = std::numeric_limits<int32_t>::min();
      return message;
    }
    int64_t rest = ns_ % 1000000000;
    message.sec = static_cast<int32_t>(ns_ / 1000000000 - (rest < 0));
    message.nanosec = static_cast<uint32_t>(rest < 0 ? rest + 1000000000 : rest);
    return message;
  }

  Duration operator+(const Duration & other) const {return sum(detail::added, other, "addition leads");}
  Duration operator-(const Duration & other) const {return sum(detail::subtracted, other, "duration subtraction leads");}
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
  template<class F>
  Duration sum(F f, const Duration & other, const char * what) const
  {
    return from_nanoseconds(detail::checked_duration(f(ns_, other.ns_, what), what));
  }
  int64_t ns_ = 0;
};
}  // namespace rclcpp
