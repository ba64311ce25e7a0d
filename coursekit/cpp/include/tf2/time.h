// Times as tf2 has them.
#pragma once
#include <chrono>
#include <cmath>
#include <string>

namespace tf2
{
using Duration = std::chrono::nanoseconds;
using TimePoint = std::chrono::time_point<std::chrono::system_clock, Duration>;
using IDuration = std::chrono::duration<int, std::nano>;
/// The newest transform that there is.
static const TimePoint TimePointZero = TimePoint(Duration::zero());
static const Duration BUFFER_CORE_DEFAULT_CACHE_TIME = std::chrono::seconds(10);

inline TimePoint get_now() {return std::chrono::time_point_cast<Duration>(std::chrono::system_clock::now());}
/// Rounded to nanoseconds; the whole seconds apart, since those of today leave too few digits for the rest.
inline Duration durationFromSec(double seconds)
{
  const double whole = std::floor(seconds);
  return std::chrono::seconds(static_cast<int64_t>(whole)) + Duration(std::llround((seconds - whole) * 1e9));
}
inline TimePoint timeFromSec(double seconds) {return TimePoint(durationFromSec(seconds));}
inline double durationToSec(const Duration & duration) {return static_cast<double>(duration.count()) / 1e9;}
inline double timeToSec(const TimePoint & time) {return durationToSec(time.time_since_epoch());}
inline std::string displayTimePoint(const TimePoint & time) {return std::to_string(timeToSec(time));}
}  // namespace tf2
