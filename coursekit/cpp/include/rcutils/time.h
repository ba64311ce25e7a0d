// Times in C: nanoseconds of the system's clock and of a steady one, as the session has them.
#pragma once
#include "coursekit/link.hpp"
#include "rcutils/logging.h"

typedef int64_t rcutils_time_point_value_t;
typedef int64_t rcutils_duration_value_t;
#define RCUTILS_S_TO_NS(seconds) ((seconds) * (1000LL * 1000LL * 1000LL))
#define RCUTILS_MS_TO_NS(milliseconds) ((milliseconds) * (1000LL * 1000LL))
#define RCUTILS_US_TO_NS(microseconds) ((microseconds) * 1000LL)
#define RCUTILS_NS_TO_S(nanoseconds) ((nanoseconds) / (1000LL * 1000LL * 1000LL))
#define RCUTILS_NS_TO_MS(nanoseconds) ((nanoseconds) / (1000LL * 1000LL))
#define RCUTILS_NS_TO_US(nanoseconds) ((nanoseconds) / 1000LL)
#define RCUTILS_STEADY_TIME rcutils_steady_time_now

inline rcutils_ret_t rcutils_system_time_now(rcutils_time_point_value_t * now)
{
  *now = coursekit::system_now();
  return RCUTILS_RET_OK;
}
inline rcutils_ret_t rcutils_steady_time_now(rcutils_time_point_value_t * now)
{
  *now = coursekit::steady_now();
  return RCUTILS_RET_OK;
}
