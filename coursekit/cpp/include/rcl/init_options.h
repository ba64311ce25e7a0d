// What C's functions know of the options of a context.
#pragma once
#include "rcl/allocator.h"
#include "rcl/domain_id.h"
#include "rcl/types.h"

struct rcl_init_options_t
{
  const void * impl;
};
