// How the states of goals travel, in C.
#pragma once
#include "rmw/qos_profiles.h"

static const rmw_qos_profile_t rcl_action_qos_profile_status_default = {
  RMW_QOS_POLICY_HISTORY_KEEP_LAST, 1, RMW_QOS_POLICY_RELIABILITY_RELIABLE, RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL,
  {0, 0}, {0, 0}, RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, {0, 0}, false};
