// Kinds of clocks, and what is told of their jumps.
#pragma once
#include "rcutils/time.h"

#define RCL_S_TO_NS RCUTILS_S_TO_NS
#define RCL_MS_TO_NS RCUTILS_MS_TO_NS
#define RCL_US_TO_NS RCUTILS_US_TO_NS
#define RCL_NS_TO_S RCUTILS_NS_TO_S
#define RCL_NS_TO_MS RCUTILS_NS_TO_MS
#define RCL_NS_TO_US RCUTILS_NS_TO_US
#include <stdint.h>

enum rcl_clock_type_t {RCL_CLOCK_UNINITIALIZED, RCL_ROS_TIME, RCL_SYSTEM_TIME, RCL_STEADY_TIME};
enum rcl_clock_change_t
{
  RCL_ROS_TIME_NO_CHANGE = 1, RCL_ROS_TIME_ACTIVATED = 2, RCL_ROS_TIME_DEACTIVATED = 3, RCL_SYSTEM_TIME_NO_CHANGE = 4
};
typedef int64_t rcl_time_point_value_t;
typedef int64_t rcl_duration_value_t;
typedef struct {rcl_duration_value_t nanoseconds;} rcl_duration_t;
typedef struct {rcl_time_point_value_t nanoseconds; rcl_clock_type_t clock_type;} rcl_time_point_t;
typedef struct {rcl_clock_change_t clock_change; rcl_duration_t delta;} rcl_time_jump_t;
/// Which jumps count; a smallest jump of 0 is none.
typedef struct {bool on_clock_change; rcl_duration_t min_forward; rcl_duration_t min_backward;} rcl_jump_threshold_t;
