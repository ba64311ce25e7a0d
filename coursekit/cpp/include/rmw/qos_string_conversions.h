// The words for policies, as parameters and tools write them.
#pragma once
#include <string.h>

#include "rmw/types.h"

#define COURSEKIT_WORD(value, word) \
  case value: return word;
#define COURSEKIT_VALUE(value, word) \
  if (strcmp(text, word) == 0) {return value;}
/// A function from a value to its word, null where it has none, and one back, with a value for what is no word.
#define COURSEKIT_WORDS(name, type, unknown, list) \
  inline const char * name ## _to_str(type value) \
  { \
    switch (value) {list(COURSEKIT_WORD) default: return nullptr;} \
  } \
  inline type name ## _from_str(const char * text) \
  { \
    list(COURSEKIT_VALUE) \
    return unknown; \
  }
#define COURSEKIT_DURABILITIES(X) \
  X(RMW_QOS_POLICY_DURABILITY_SYSTEM_DEFAULT, "system_default") \
  X(RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL, "transient_local") \
  X(RMW_QOS_POLICY_DURABILITY_VOLATILE, "volatile")
#define COURSEKIT_HISTORIES(X) \
  X(RMW_QOS_POLICY_HISTORY_SYSTEM_DEFAULT, "system_default") \
  X(RMW_QOS_POLICY_HISTORY_KEEP_LAST, "keep_last") \
  X(RMW_QOS_POLICY_HISTORY_KEEP_ALL, "keep_all")
#define COURSEKIT_LIVELINESSES(X) \
  X(RMW_QOS_POLICY_LIVELINESS_SYSTEM_DEFAULT, "system_default") \
  X(RMW_QOS_POLICY_LIVELINESS_AUTOMATIC, "automatic") \
  X(RMW_QOS_POLICY_LIVELINESS_MANUAL_BY_TOPIC, "manual_by_topic")
#define COURSEKIT_RELIABILITIES(X) \
  X(RMW_QOS_POLICY_RELIABILITY_SYSTEM_DEFAULT, "system_default") \
  X(RMW_QOS_POLICY_RELIABILITY_RELIABLE, "reliable") \
  X(RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT, "best_effort")
#define COURSEKIT_KINDS(X) \
  X(RMW_QOS_POLICY_DURABILITY, "durability") \
  X(RMW_QOS_POLICY_DEADLINE, "deadline") \
  X(RMW_QOS_POLICY_LIVELINESS, "liveliness") \
  X(RMW_QOS_POLICY_RELIABILITY, "reliability") \
  X(RMW_QOS_POLICY_HISTORY, "history") \
  X(RMW_QOS_POLICY_LIFESPAN, "lifespan") \
  X(RMW_QOS_POLICY_DEPTH, "depth") \
  X(RMW_QOS_POLICY_LIVELINESS_LEASE_DURATION, "liveliness_lease_duration") \
  X(RMW_QOS_POLICY_AVOID_ROS_NAMESPACE_CONVENTIONS, "avoid_ros_namespace_conventions")

COURSEKIT_WORDS(
  rmw_qos_durability_policy, rmw_qos_durability_policy_t, RMW_QOS_POLICY_DURABILITY_UNKNOWN, COURSEKIT_DURABILITIES)
COURSEKIT_WORDS(rmw_qos_history_policy, rmw_qos_history_policy_t, RMW_QOS_POLICY_HISTORY_UNKNOWN, COURSEKIT_HISTORIES)
COURSEKIT_WORDS(
  rmw_qos_liveliness_policy, rmw_qos_liveliness_policy_t, RMW_QOS_POLICY_LIVELINESS_UNKNOWN, COURSEKIT_LIVELINESSES)
COURSEKIT_WORDS(
  rmw_qos_reliability_policy, rmw_qos_reliability_policy_t, RMW_QOS_POLICY_RELIABILITY_UNKNOWN, COURSEKIT_RELIABILITIES)
COURSEKIT_WORDS(rmw_qos_policy_kind, rmw_qos_policy_kind_t, RMW_QOS_POLICY_INVALID, COURSEKIT_KINDS)
