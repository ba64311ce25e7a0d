// Kinds of clocks, and what is told of their jumps.
#pragma once
#include <atomic>

#include "rcl/types.h"
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
/// A clock as C's functions know it: its kind, and the time that a program sets where it has taken ROS time over.
struct rcl_clock_t
{
  rcl_clock_type_t type = RCL_CLOCK_UNINITIALIZED;
  std::atomic<bool> overridden{false};
  std::atomic<rcl_time_point_value_t> time{0};
};
typedef struct {rcl_clock_change_t clock_change; rcl_duration_t delta;} rcl_time_jump_t;
/// Which jumps count; a smallest jump of 0 is none.
typedef struct {bool on_clock_change; rcl_duration_t min_forward; rcl_duration_t min_backward;} rcl_jump_threshold_t;

// -- ROS time that the program itself gives

inline rcl_ret_t rcl_switch_ros_time_override(rcl_clock_t * clock, bool on)
{
  if (!clock) {
    return RCL_RET_INVALID_ARGUMENT;
  }
  if (clock->type != RCL_ROS_TIME) {
    return RCL_RET_ERROR;
  }
  clock->overridden = on;
  return RCL_RET_OK;
}
inline rcl_ret_t rcl_enable_ros_time_override(rcl_clock_t * clock) {return rcl_switch_ros_time_override(clock, true);}
inline rcl_ret_t rcl_disable_ros_time_override(rcl_clock_t * clock) {return rcl_switch_ros_time_override(clock, false);}
inline rcl_ret_t rcl_is_enabled_ros_time_override(rcl_clock_t * clock, bool * is_enabled)
{
  if (!clock || !is_enabled) {
    return RCL_RET_INVALID_ARGUMENT;
  }
  *is_enabled = clock->overridden;
  return clock->type == RCL_ROS_TIME ? RCL_RET_OK : RCL_RET_ERROR;
}
inline rcl_ret_t rcl_set_ros_time_override(rcl_clock_t * clock, rcl_time_point_value_t time_value)
{
  if (!clock) {
    return RCL_RET_INVALID_ARGUMENT;
  }
  clock->time = time_value;
  return clock->type == RCL_ROS_TIME ? RCL_RET_OK : RCL_RET_ERROR;
}
