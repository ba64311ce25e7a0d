// The names of the services and topics of an action, in C: the program frees them.
#pragma once
#include "rcl/error_handling.h"
#include "rcl_action/types.h"
#include "rcutils/format_string.h"

inline rcl_ret_t coursekit_action_name(const char * action_name, const char * part, rcl_allocator_t allocator, char ** name)
{
  RCL_CHECK_ALLOCATOR_WITH_MSG(&allocator, "allocator is invalid", return RCL_RET_INVALID_ARGUMENT);
  RCL_CHECK_ARGUMENT_FOR_NULL(action_name, RCL_RET_INVALID_ARGUMENT);
  if (!*action_name) {
    RCL_SET_ERROR_MSG("invalid empty action name");
    return RCL_RET_ACTION_NAME_INVALID;
  }
  RCL_CHECK_ARGUMENT_FOR_NULL(name, RCL_RET_INVALID_ARGUMENT);
  if (*name) {
    RCL_SET_ERROR_MSG_WITH_FORMAT_STRING("writing action %s name may leak memory", part);
    return RCL_RET_INVALID_ARGUMENT;
  }
  *name = rcutils_format_string(allocator, "%s/_action/%s", action_name, part);
  RCL_CHECK_FOR_NULL_WITH_MSG(*name, "failed to allocate memory for action name", return RCL_RET_BAD_ALLOC);
  return RCL_RET_OK;
}
#define COURSEKIT_ACTION_NAME(function, part) \
  inline rcl_ret_t function(const char * action_name, rcl_allocator_t allocator, char ** name) \
  { \
    return coursekit_action_name(action_name, part, allocator, name); \
  }
COURSEKIT_ACTION_NAME(rcl_action_get_goal_service_name, "send_goal")
COURSEKIT_ACTION_NAME(rcl_action_get_cancel_service_name, "cancel_goal")
COURSEKIT_ACTION_NAME(rcl_action_get_result_service_name, "get_result")
COURSEKIT_ACTION_NAME(rcl_action_get_feedback_topic_name, "feedback")
COURSEKIT_ACTION_NAME(rcl_action_get_status_topic_name, "status")
#undef COURSEKIT_ACTION_NAME
