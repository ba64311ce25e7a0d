// Logging with a logger's name instead of a logger, or without any.
#pragma once
#include "rclcpp/logging.hpp"
#include "rcutils/time.h"

/// Log at most once in so many milliseconds of the clock that a function tells.
#define COURSEKIT_LOG_THROTTLE(log, time_now, milliseconds, ...) \
  do { \
    static rcutils_time_point_value_t coursekit_next = 0; \
    static bool coursekit_first = true; \
    rcutils_time_point_value_t coursekit_at = 0; \
    if (time_now(&coursekit_at) == RCUTILS_RET_OK && (coursekit_first || coursekit_at >= coursekit_next)) { \
      coursekit_first = false; \
      coursekit_next = coursekit_at + RCUTILS_MS_TO_NS(static_cast<rcutils_time_point_value_t>(milliseconds)); \
      log(__VA_ARGS__); \
    } \
  } while (0)

#define RCUTILS_LOG_DEBUG(...) RCLCPP_DEBUG(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_NAMED(name, ...) RCLCPP_DEBUG(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_ONCE(...) RCLCPP_DEBUG_ONCE(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_ONCE_NAMED(name, ...) RCLCPP_DEBUG_ONCE(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_SKIPFIRST(...) RCLCPP_DEBUG_SKIPFIRST(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_SKIPFIRST_NAMED(name, ...) RCLCPP_DEBUG_SKIPFIRST(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_EXPRESSION(expression, ...) \
  RCLCPP_DEBUG_EXPRESSION(rclcpp::get_logger(""), expression, __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_EXPRESSION_NAMED(expression, name, ...) \
  RCLCPP_DEBUG_EXPRESSION(rclcpp::get_logger(name), expression, __VA_ARGS__)
#define RCUTILS_LOG_INFO(...) RCLCPP_INFO(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_INFO_NAMED(name, ...) RCLCPP_INFO(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_INFO_ONCE(...) RCLCPP_INFO_ONCE(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_INFO_ONCE_NAMED(name, ...) RCLCPP_INFO_ONCE(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_INFO_SKIPFIRST(...) RCLCPP_INFO_SKIPFIRST(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_INFO_SKIPFIRST_NAMED(name, ...) RCLCPP_INFO_SKIPFIRST(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_INFO_EXPRESSION(expression, ...) \
  RCLCPP_INFO_EXPRESSION(rclcpp::get_logger(""), expression, __VA_ARGS__)
#define RCUTILS_LOG_INFO_EXPRESSION_NAMED(expression, name, ...) \
  RCLCPP_INFO_EXPRESSION(rclcpp::get_logger(name), expression, __VA_ARGS__)
#define RCUTILS_LOG_WARN(...) RCLCPP_WARN(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_WARN_NAMED(name, ...) RCLCPP_WARN(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_WARN_ONCE(...) RCLCPP_WARN_ONCE(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_WARN_ONCE_NAMED(name, ...) RCLCPP_WARN_ONCE(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_WARN_SKIPFIRST(...) RCLCPP_WARN_SKIPFIRST(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_WARN_SKIPFIRST_NAMED(name, ...) RCLCPP_WARN_SKIPFIRST(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_WARN_EXPRESSION(expression, ...) \
  RCLCPP_WARN_EXPRESSION(rclcpp::get_logger(""), expression, __VA_ARGS__)
#define RCUTILS_LOG_WARN_EXPRESSION_NAMED(expression, name, ...) \
  RCLCPP_WARN_EXPRESSION(rclcpp::get_logger(name), expression, __VA_ARGS__)
#define RCUTILS_LOG_ERROR(...) RCLCPP_ERROR(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_NAMED(name, ...) RCLCPP_ERROR(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_ONCE(...) RCLCPP_ERROR_ONCE(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_ONCE_NAMED(name, ...) RCLCPP_ERROR_ONCE(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_SKIPFIRST(...) RCLCPP_ERROR_SKIPFIRST(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_SKIPFIRST_NAMED(name, ...) RCLCPP_ERROR_SKIPFIRST(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_EXPRESSION(expression, ...) \
  RCLCPP_ERROR_EXPRESSION(rclcpp::get_logger(""), expression, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_EXPRESSION_NAMED(expression, name, ...) \
  RCLCPP_ERROR_EXPRESSION(rclcpp::get_logger(name), expression, __VA_ARGS__)
#define RCUTILS_LOG_FATAL(...) RCLCPP_FATAL(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_NAMED(name, ...) RCLCPP_FATAL(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_ONCE(...) RCLCPP_FATAL_ONCE(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_ONCE_NAMED(name, ...) RCLCPP_FATAL_ONCE(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_SKIPFIRST(...) RCLCPP_FATAL_SKIPFIRST(rclcpp::get_logger(""), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_SKIPFIRST_NAMED(name, ...) RCLCPP_FATAL_SKIPFIRST(rclcpp::get_logger(name), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_EXPRESSION(expression, ...) \
  RCLCPP_FATAL_EXPRESSION(rclcpp::get_logger(""), expression, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_EXPRESSION_NAMED(expression, name, ...) \
  RCLCPP_FATAL_EXPRESSION(rclcpp::get_logger(name), expression, __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_DEBUG, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_DEBUG_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_INFO_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_INFO, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_INFO_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_INFO_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_WARN_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_WARN, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_WARN_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_WARN_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_ERROR, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_ERROR_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_FATAL, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_FATAL_NAMED, time_now, duration, name, __VA_ARGS__)

/// Log where a function says so, and at most once in so many milliseconds from the second time on.
#define RCUTILS_LOG_DEBUG_FUNCTION(function, ...) RCUTILS_LOG_DEBUG_EXPRESSION((function)(), __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_FUNCTION_NAMED(function, name, ...) \
  RCUTILS_LOG_DEBUG_EXPRESSION_NAMED((function)(), name, __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_SKIPFIRST_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_DEBUG_SKIPFIRST, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_DEBUG_SKIPFIRST_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_DEBUG_SKIPFIRST_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_INFO_FUNCTION(function, ...) RCUTILS_LOG_INFO_EXPRESSION((function)(), __VA_ARGS__)
#define RCUTILS_LOG_INFO_FUNCTION_NAMED(function, name, ...) \
  RCUTILS_LOG_INFO_EXPRESSION_NAMED((function)(), name, __VA_ARGS__)
#define RCUTILS_LOG_INFO_SKIPFIRST_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_INFO_SKIPFIRST, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_INFO_SKIPFIRST_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_INFO_SKIPFIRST_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_WARN_FUNCTION(function, ...) RCUTILS_LOG_WARN_EXPRESSION((function)(), __VA_ARGS__)
#define RCUTILS_LOG_WARN_FUNCTION_NAMED(function, name, ...) \
  RCUTILS_LOG_WARN_EXPRESSION_NAMED((function)(), name, __VA_ARGS__)
#define RCUTILS_LOG_WARN_SKIPFIRST_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_WARN_SKIPFIRST, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_WARN_SKIPFIRST_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_WARN_SKIPFIRST_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_FUNCTION(function, ...) RCUTILS_LOG_ERROR_EXPRESSION((function)(), __VA_ARGS__)
#define RCUTILS_LOG_ERROR_FUNCTION_NAMED(function, name, ...) \
  RCUTILS_LOG_ERROR_EXPRESSION_NAMED((function)(), name, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_SKIPFIRST_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_ERROR_SKIPFIRST, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_ERROR_SKIPFIRST_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_ERROR_SKIPFIRST_NAMED, time_now, duration, name, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_FUNCTION(function, ...) RCUTILS_LOG_FATAL_EXPRESSION((function)(), __VA_ARGS__)
#define RCUTILS_LOG_FATAL_FUNCTION_NAMED(function, name, ...) \
  RCUTILS_LOG_FATAL_EXPRESSION_NAMED((function)(), name, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE(time_now, duration, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_FATAL_SKIPFIRST, time_now, duration, __VA_ARGS__)
#define RCUTILS_LOG_FATAL_SKIPFIRST_THROTTLE_NAMED(time_now, duration, name, ...) \
  COURSEKIT_LOG_THROTTLE(RCUTILS_LOG_FATAL_SKIPFIRST_NAMED, time_now, duration, name, __VA_ARGS__)
