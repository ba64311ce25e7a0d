// Logging with a logger's name instead of a logger, or without any.
#pragma once
#include "rclcpp/logging.hpp"

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
