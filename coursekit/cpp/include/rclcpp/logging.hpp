// RCLCPP_INFO and its relatives: each level plain, once, throttled, skipping the first, on a condition, as a stream.
#pragma once
#include <atomic>
#include <sstream>
#include <type_traits>

#include "rclcpp/clock.hpp"
#include "rclcpp/logger.hpp"

#ifndef RCLCPP_LOG_MIN_SEVERITY
#define RCLCPP_LOG_MIN_SEVERITY RCLCPP_LOG_MIN_SEVERITY_DEBUG
#endif
#define RCLCPP_LOG_MIN_SEVERITY_DEBUG 0
#define RCLCPP_LOG_MIN_SEVERITY_INFO 1
#define RCLCPP_LOG_MIN_SEVERITY_WARN 2
#define RCLCPP_LOG_MIN_SEVERITY_ERROR 3
#define RCLCPP_LOG_MIN_SEVERITY_FATAL 4
#define RCLCPP_LOG_MIN_SEVERITY_NONE 5

namespace rclcpp
{
/// Whether a line of this level is shown: only then are a macro's condition and arguments evaluated.
bool log_enabled(const Logger & logger, int level);
void log(const Logger & logger, int level, const char * file, const char * function, int line, const char * format, ...)
#ifdef __GNUC__
__attribute__((format(printf, 6, 7)))
#endif
;
}  // namespace rclcpp

#define COURSEKIT_LOG_IF(condition, level, logger, ...) \
  do { \
    static_assert( \
      std::is_same_v<std::remove_cv_t<std::remove_reference_t<decltype(logger)>>, rclcpp::Logger>, \
      "First argument to logging macros must be an rclcpp::Logger"); \
    if (rclcpp::log_enabled(logger, level) && (condition)) { \
      rclcpp::log(logger, level, __FILE__, __func__, __LINE__, __VA_ARGS__); \
    } \
  } while (0)
#define COURSEKIT_STREAM_IF(condition, level, logger, stream_arg) \
  do { \
    static_assert( \
      std::is_same_v<std::remove_cv_t<std::remove_reference_t<decltype(logger)>>, rclcpp::Logger>, \
      "First argument to logging macros must be an rclcpp::Logger"); \
    if (rclcpp::log_enabled(logger, level) && (condition)) { \
      std::stringstream coursekit_stream; \
      coursekit_stream << stream_arg; \
      rclcpp::log(logger, level, __FILE__, __func__, __LINE__, "%s", coursekit_stream.str().c_str()); \
    } \
  } while (0)

#define COURSEKIT_ONCE ([] {static std::atomic<bool> done{false}; return !done.exchange(true);}())
#define COURSEKIT_SKIPFIRST ([] {static std::atomic<bool> done{false}; return done.exchange(true);}())
#define COURSEKIT_THROTTLE(clock, duration) \
  ([](rclcpp::Clock & throttle_clock, int64_t milliseconds) { \
    static std::atomic<int64_t> last{0}; \
    int64_t now = throttle_clock.now().nanoseconds(); \
    if (now < last + milliseconds * 1000000) {return false;} \
    last = now; \
    return true; \
  }(clock, static_cast<int64_t>(duration)))

#if RCLCPP_LOG_MIN_SEVERITY <= RCLCPP_LOG_MIN_SEVERITY_DEBUG
#define RCLCPP_DEBUG(logger, ...) COURSEKIT_LOG_IF(true, 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_ONCE(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_ONCE, 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_EXPRESSION(logger, expression, ...) COURSEKIT_LOG_IF(expression, 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_FUNCTION(logger, function, ...) COURSEKIT_LOG_IF((*function)(), 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_SKIPFIRST(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST, 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_THROTTLE(clock, duration), 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 10, logger, __VA_ARGS__)
#define RCLCPP_DEBUG_STREAM(logger, stream_arg) COURSEKIT_STREAM_IF(true, 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_ONCE(logger, stream_arg) COURSEKIT_STREAM_IF(COURSEKIT_ONCE, 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_EXPRESSION(logger, expression, stream_arg) \
  COURSEKIT_STREAM_IF(expression, 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_FUNCTION(logger, function, stream_arg) \
  COURSEKIT_STREAM_IF((*function)(), 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(logger, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST, 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_THROTTLE(clock, duration), 10, logger, stream_arg)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 10, logger, stream_arg)
#else
#define RCLCPP_DEBUG(...)
#define RCLCPP_DEBUG_ONCE(...)
#define RCLCPP_DEBUG_EXPRESSION(...)
#define RCLCPP_DEBUG_FUNCTION(...)
#define RCLCPP_DEBUG_SKIPFIRST(...)
#define RCLCPP_DEBUG_THROTTLE(...)
#define RCLCPP_DEBUG_SKIPFIRST_THROTTLE(...)
#define RCLCPP_DEBUG_STREAM(...)
#define RCLCPP_DEBUG_STREAM_ONCE(...)
#define RCLCPP_DEBUG_STREAM_EXPRESSION(...)
#define RCLCPP_DEBUG_STREAM_FUNCTION(...)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST(...)
#define RCLCPP_DEBUG_STREAM_THROTTLE(...)
#define RCLCPP_DEBUG_STREAM_SKIPFIRST_THROTTLE(...)
#endif
#if RCLCPP_LOG_MIN_SEVERITY <= RCLCPP_LOG_MIN_SEVERITY_INFO
#define RCLCPP_INFO(logger, ...) COURSEKIT_LOG_IF(true, 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_ONCE(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_ONCE, 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_EXPRESSION(logger, expression, ...) COURSEKIT_LOG_IF(expression, 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_FUNCTION(logger, function, ...) COURSEKIT_LOG_IF((*function)(), 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_SKIPFIRST(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST, 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_THROTTLE(clock, duration), 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 20, logger, __VA_ARGS__)
#define RCLCPP_INFO_STREAM(logger, stream_arg) COURSEKIT_STREAM_IF(true, 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_ONCE(logger, stream_arg) COURSEKIT_STREAM_IF(COURSEKIT_ONCE, 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_EXPRESSION(logger, expression, stream_arg) \
  COURSEKIT_STREAM_IF(expression, 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_FUNCTION(logger, function, stream_arg) \
  COURSEKIT_STREAM_IF((*function)(), 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_SKIPFIRST(logger, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST, 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_THROTTLE(clock, duration), 20, logger, stream_arg)
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 20, logger, stream_arg)
#else
#define RCLCPP_INFO(...)
#define RCLCPP_INFO_ONCE(...)
#define RCLCPP_INFO_EXPRESSION(...)
#define RCLCPP_INFO_FUNCTION(...)
#define RCLCPP_INFO_SKIPFIRST(...)
#define RCLCPP_INFO_THROTTLE(...)
#define RCLCPP_INFO_SKIPFIRST_THROTTLE(...)
#define RCLCPP_INFO_STREAM(...)
#define RCLCPP_INFO_STREAM_ONCE(...)
#define RCLCPP_INFO_STREAM_EXPRESSION(...)
#define RCLCPP_INFO_STREAM_FUNCTION(...)
#define RCLCPP_INFO_STREAM_SKIPFIRST(...)
#define RCLCPP_INFO_STREAM_THROTTLE(...)
#define RCLCPP_INFO_STREAM_SKIPFIRST_THROTTLE(...)
#endif
#if RCLCPP_LOG_MIN_SEVERITY <= RCLCPP_LOG_MIN_SEVERITY_WARN
#define RCLCPP_WARN(logger, ...) COURSEKIT_LOG_IF(true, 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_ONCE(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_ONCE, 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_EXPRESSION(logger, expression, ...) COURSEKIT_LOG_IF(expression, 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_FUNCTION(logger, function, ...) COURSEKIT_LOG_IF((*function)(), 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_SKIPFIRST(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST, 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_THROTTLE(clock, duration), 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 30, logger, __VA_ARGS__)
#define RCLCPP_WARN_STREAM(logger, stream_arg) COURSEKIT_STREAM_IF(true, 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_ONCE(logger, stream_arg) COURSEKIT_STREAM_IF(COURSEKIT_ONCE, 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_EXPRESSION(logger, expression, stream_arg) \
  COURSEKIT_STREAM_IF(expression, 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_FUNCTION(logger, function, stream_arg) \
  COURSEKIT_STREAM_IF((*function)(), 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_SKIPFIRST(logger, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST, 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_THROTTLE(clock, duration), 30, logger, stream_arg)
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 30, logger, stream_arg)
#else
#define RCLCPP_WARN(...)
#define RCLCPP_WARN_ONCE(...)
#define RCLCPP_WARN_EXPRESSION(...)
#define RCLCPP_WARN_FUNCTION(...)
#define RCLCPP_WARN_SKIPFIRST(...)
#define RCLCPP_WARN_THROTTLE(...)
#define RCLCPP_WARN_SKIPFIRST_THROTTLE(...)
#define RCLCPP_WARN_STREAM(...)
#define RCLCPP_WARN_STREAM_ONCE(...)
#define RCLCPP_WARN_STREAM_EXPRESSION(...)
#define RCLCPP_WARN_STREAM_FUNCTION(...)
#define RCLCPP_WARN_STREAM_SKIPFIRST(...)
#define RCLCPP_WARN_STREAM_THROTTLE(...)
#define RCLCPP_WARN_STREAM_SKIPFIRST_THROTTLE(...)
#endif
#if RCLCPP_LOG_MIN_SEVERITY <= RCLCPP_LOG_MIN_SEVERITY_ERROR
#define RCLCPP_ERROR(logger, ...) COURSEKIT_LOG_IF(true, 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_ONCE(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_ONCE, 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_EXPRESSION(logger, expression, ...) COURSEKIT_LOG_IF(expression, 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_FUNCTION(logger, function, ...) COURSEKIT_LOG_IF((*function)(), 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_SKIPFIRST(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST, 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_THROTTLE(clock, duration), 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 40, logger, __VA_ARGS__)
#define RCLCPP_ERROR_STREAM(logger, stream_arg) COURSEKIT_STREAM_IF(true, 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_ONCE(logger, stream_arg) COURSEKIT_STREAM_IF(COURSEKIT_ONCE, 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_EXPRESSION(logger, expression, stream_arg) \
  COURSEKIT_STREAM_IF(expression, 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_FUNCTION(logger, function, stream_arg) \
  COURSEKIT_STREAM_IF((*function)(), 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_SKIPFIRST(logger, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST, 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_THROTTLE(clock, duration), 40, logger, stream_arg)
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 40, logger, stream_arg)
#else
#define RCLCPP_ERROR(...)
#define RCLCPP_ERROR_ONCE(...)
#define RCLCPP_ERROR_EXPRESSION(...)
#define RCLCPP_ERROR_FUNCTION(...)
#define RCLCPP_ERROR_SKIPFIRST(...)
#define RCLCPP_ERROR_THROTTLE(...)
#define RCLCPP_ERROR_SKIPFIRST_THROTTLE(...)
#define RCLCPP_ERROR_STREAM(...)
#define RCLCPP_ERROR_STREAM_ONCE(...)
#define RCLCPP_ERROR_STREAM_EXPRESSION(...)
#define RCLCPP_ERROR_STREAM_FUNCTION(...)
#define RCLCPP_ERROR_STREAM_SKIPFIRST(...)
#define RCLCPP_ERROR_STREAM_THROTTLE(...)
#define RCLCPP_ERROR_STREAM_SKIPFIRST_THROTTLE(...)
#endif
#if RCLCPP_LOG_MIN_SEVERITY <= RCLCPP_LOG_MIN_SEVERITY_FATAL
#define RCLCPP_FATAL(logger, ...) COURSEKIT_LOG_IF(true, 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_ONCE(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_ONCE, 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_EXPRESSION(logger, expression, ...) COURSEKIT_LOG_IF(expression, 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_FUNCTION(logger, function, ...) COURSEKIT_LOG_IF((*function)(), 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_SKIPFIRST(logger, ...) COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST, 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_THROTTLE(clock, duration), 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(logger, clock, duration, ...) \
  COURSEKIT_LOG_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 50, logger, __VA_ARGS__)
#define RCLCPP_FATAL_STREAM(logger, stream_arg) COURSEKIT_STREAM_IF(true, 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_ONCE(logger, stream_arg) COURSEKIT_STREAM_IF(COURSEKIT_ONCE, 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_EXPRESSION(logger, expression, stream_arg) \
  COURSEKIT_STREAM_IF(expression, 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_FUNCTION(logger, function, stream_arg) \
  COURSEKIT_STREAM_IF((*function)(), 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_SKIPFIRST(logger, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST, 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_THROTTLE(clock, duration), 50, logger, stream_arg)
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(logger, clock, duration, stream_arg) \
  COURSEKIT_STREAM_IF(COURSEKIT_SKIPFIRST && COURSEKIT_THROTTLE(clock, duration), 50, logger, stream_arg)
#else
#define RCLCPP_FATAL(...)
#define RCLCPP_FATAL_ONCE(...)
#define RCLCPP_FATAL_EXPRESSION(...)
#define RCLCPP_FATAL_FUNCTION(...)
#define RCLCPP_FATAL_SKIPFIRST(...)
#define RCLCPP_FATAL_THROTTLE(...)
#define RCLCPP_FATAL_SKIPFIRST_THROTTLE(...)
#define RCLCPP_FATAL_STREAM(...)
#define RCLCPP_FATAL_STREAM_ONCE(...)
#define RCLCPP_FATAL_STREAM_EXPRESSION(...)
#define RCLCPP_FATAL_STREAM_FUNCTION(...)
#define RCLCPP_FATAL_STREAM_SKIPFIRST(...)
#define RCLCPP_FATAL_STREAM_THROTTLE(...)
#define RCLCPP_FATAL_STREAM_SKIPFIRST_THROTTLE(...)
#endif
#include "rcutils/logging_macros.h"  // Humble's brings them along
