// What clients and servers of actions have in C.
#pragma once
#include "action_msgs/msg/goal_info.hpp"
#include "rcl/allocator.h"
#include "rcl/types.h"

#define RCL_RET_ACTION_NAME_INVALID 2000
#define UUID_SIZE 16

typedef action_msgs::msg::GoalInfo rcl_action_goal_info_t;
inline rcl_action_goal_info_t rcl_action_get_zero_initialized_goal_info() {return {};}

/// How long a server keeps results.
struct rcl_action_server_options_t
{
  struct
  {
    int64_t nanoseconds = 900'000'000'000;
  } result_timeout;
};
struct rcl_action_client_options_t {};
inline rcl_action_server_options_t rcl_action_server_get_default_options() {return {};}
inline rcl_action_client_options_t rcl_action_client_get_default_options() {return {};}
