// What is waited for, and after the wait what is ready: those that are not are null then, as rcl has it.
#pragma once
#include <vector>

#include "coursekit/entity.hpp"
#include "rcl/types.h"

using rcl_subscription_t = coursekit::Entity;
using rcl_guard_condition_t = coursekit::Entity;
using rcl_timer_t = coursekit::Entity;
using rcl_client_t = coursekit::Entity;
using rcl_service_t = coursekit::Entity;
using rcl_event_t = coursekit::Entity;

struct rcl_wait_set_t
{
  std::vector<const coursekit::Entity *> subscriptions, guard_conditions, timers, clients, services, events;
  size_t size_of_subscriptions = 0, size_of_guard_conditions = 0, size_of_timers = 0;
  size_t size_of_clients = 0, size_of_services = 0, size_of_events = 0;
};

inline rcl_wait_set_t rcl_get_zero_initialized_wait_set() {return {};}

#define COURSEKIT_ADD(kind, plural) \
  inline rcl_ret_t rcl_wait_set_add_ ## kind(rcl_wait_set_t * set, const coursekit::Entity * one, size_t * index) \
  { \
    if (!set || !one) { \
      return RCL_RET_INVALID_ARGUMENT; \
    } \
    if (index) { \
      *index = set->plural.size(); \
    } \
    set->plural.push_back(one); \
    set->size_of_ ## plural = set->plural.size(); \
    return RCL_RET_OK; \
  }
COURSEKIT_ADD(subscription, subscriptions)
COURSEKIT_ADD(guard_condition, guard_conditions)
COURSEKIT_ADD(timer, timers)
COURSEKIT_ADD(client, clients)
COURSEKIT_ADD(service, services)
COURSEKIT_ADD(event, events)
#undef COURSEKIT_ADD
