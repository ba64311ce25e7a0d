// ROS domains.
#pragma once
#include <stddef.h>
#include <stdint.h>

/// Stands for the domain that $ROS_DOMAIN_ID names.
#define RCL_DEFAULT_DOMAIN_ID SIZE_MAX
