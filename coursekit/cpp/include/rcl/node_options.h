// What C's functions know of the options of a node.
#pragma once
#include "rcl/allocator.h"
#include "rcl/logging_rosout.h"

struct rcl_node_options_t
{
  rcl_allocator_t allocator;
  bool use_global_arguments;
  bool enable_rosout;
  rmw_qos_profile_t rosout_qos;
};
