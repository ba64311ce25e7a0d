// Times in C: nanoseconds of the system's clock and of a steady one, as the session has them.
#pragma once
#include <cinttypes>
#include <cstdio>

#include "coursekit/link.hpp"
#include "rcutils/logging.h"

#define RCUTILS_S_TO_NS(seconds) ((seconds) * (1000LL * 1000LL * 1000LL))
#define RCUTILS_MS_TO_NS(milliseconds) ((milliseconds) * (1000LL * 1000LL))
#define RCUTILS_US_TO_NS(microseconds) ((microseconds) * 1000LL)
#define RCUTILS_NS_TO_S(nanoseconds) ((nanoseconds) / (1000LL * 1000LL * 1000LL))
#define RCUTILS_NS_TO_MS(nanoseconds) ((nanoseconds) / (1000LL * 1000LL))
#define RCUTILS_NS_TO_US(nanoseconds) ((nanoseconds) / 1000LL)
#define RCUTILS_STEADY_TIME rcutils_steady_time_now

inline rcutils_ret_t rcutils_system_time_now(rcutils_time_point_value_t * now)
{
  if (!now) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  *now = coursekit::system_now();
  return RCUTILS_RET_OK;
}
inline rcutils_ret_t rcutils_steady_time_now(rcutils_time_point_value_t * now)
{
  if (!now) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  *now = coursekit::steady_now();
  return RCUTILS_RET_OK;
}
/// Nineteen digits, as far as there is room for them.
inline rcutils_ret_t rcutils_time_point_value_as_nanoseconds_string(
  const rcutils_time_point_value_t * time, char * text, size_t size)
{
  if (!time || !text) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  snprintf(text, size, "%s%.19" PRIu64, *time < 0 ? "-" : "", *time < 0 ? 0 - static_cast<uint64_t>(*time) : *time);
  return RCUTILS_RET_OK;
}
/// Ten digits, a point, and nine more, as far as there is room for them.
inline rcutils_ret_t rcutils_time_point_value_as_seconds_string(
  const rcutils_time_point_value_t * time, char * text, size_t size)
{
  if (!time || !text) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  const uint64_t all = *time < 0 ? 0 - static_cast<uint64_t>(*time) : *time;
  snprintf(text, size, "%s%.10" PRIu64 ".%.9" PRIu64, *time < 0 ? "-" : "", all / 1000000000, all % 1000000000);
  return RCUTILS_RET_OK;
}
