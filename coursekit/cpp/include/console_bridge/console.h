// The log of libraries that know nothing of ROS, as lines of the log.
#pragma once
#include "rcutils/logging_macros.h"
#define CONSOLE_BRIDGE_logDebug(...) RCUTILS_LOG_DEBUG_NAMED("console_bridge", __VA_ARGS__)
#define CONSOLE_BRIDGE_logInform(...) RCUTILS_LOG_INFO_NAMED("console_bridge", __VA_ARGS__)
#define CONSOLE_BRIDGE_logWarn(...) RCUTILS_LOG_WARN_NAMED("console_bridge", __VA_ARGS__)
#define CONSOLE_BRIDGE_logError(...) RCUTILS_LOG_ERROR_NAMED("console_bridge", __VA_ARGS__)
