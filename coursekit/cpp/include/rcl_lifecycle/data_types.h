// The states of managed nodes and the ways between them, in C.
#pragma once
#include <stdint.h>

#include "rcl/allocator.h"

struct rcl_lifecycle_transition_t;
struct rcl_lifecycle_state_t
{
  const char * label;
  uint8_t id;
  rcl_lifecycle_transition_t * valid_transitions;
  unsigned int valid_transition_size;
};
struct rcl_lifecycle_transition_t
{
  const char * label;
  unsigned int id;
  rcl_lifecycle_state_t * start;
  rcl_lifecycle_state_t * goal;
};
