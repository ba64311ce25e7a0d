// Levels of loggers, and where their lines go, in C.
#pragma once
#include <cstdarg>
#include <cstdint>
#include <cstring>

#include "rclcpp/logger.hpp"
#include "rcutils/allocator.h"
#include "rcutils/error_handling.h"
#include "rcutils/types/rcutils_ret.h"

typedef int64_t rcutils_time_point_value_t;
typedef int64_t rcutils_duration_value_t;
#define RCUTILS_LOGGING_SEPARATOR_STRING "."
#define RCUTILS_DEFAULT_LOGGER_DEFAULT_LEVEL RCUTILS_LOG_SEVERITY_INFO

enum RCUTILS_LOG_SEVERITY
{
  RCUTILS_LOG_SEVERITY_UNSET = 0, RCUTILS_LOG_SEVERITY_DEBUG = 10, RCUTILS_LOG_SEVERITY_INFO = 20,
  RCUTILS_LOG_SEVERITY_WARN = 30, RCUTILS_LOG_SEVERITY_ERROR = 40, RCUTILS_LOG_SEVERITY_FATAL = 50,
};
/// The name of each level, by its number.
extern const char * const g_rcutils_log_severity_names[RCUTILS_LOG_SEVERITY_FATAL + 1];
inline rcutils_ret_t rcutils_logging_severity_level_from_string(const char * text, rcutils_allocator_t, int * severity)
{
  if (!text || !severity) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  std::string upper;
  for (const char * c = text; *c; ++c) {
    upper += static_cast<char>(std::toupper(static_cast<unsigned char>(*c)));
  }
  for (int level = 0; level <= RCUTILS_LOG_SEVERITY_FATAL; level += 10) {
    if (upper == g_rcutils_log_severity_names[level]) {
      *severity = level;
      return RCUTILS_RET_OK;
    }
  }
  return RCUTILS_RET_LOGGING_SEVERITY_STRING_INVALID;
}
inline rcutils_ret_t rcutils_logging_set_logger_level(const char * name, int level)
{
  if (!name || level < 0 || level > RCUTILS_LOG_SEVERITY_FATAL || level % 10) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  rclcpp::Logger(name).set_level(static_cast<rclcpp::Logger::Level>(level));
  return RCUTILS_RET_OK;
}
/// The level that was set for this logger itself, 0 where none was, -1 without a name.
int rcutils_logging_get_logger_level(const char * name);
/// That of the logger whose name has so many letters.
inline int rcutils_logging_get_logger_leveln(const char * name, size_t length)
{
  return name ? rcutils_logging_get_logger_level(std::string(name, length).c_str()) : -1;
}
inline int rcutils_logging_get_logger_effective_level(const char * name)
{
  return name ? static_cast<int>(rclcpp::Logger(name).get_effective_level()) : -1;
}
inline bool rcutils_logging_logger_is_enabled_for(const char * name, int severity)
{
  return severity >= rcutils_logging_get_logger_effective_level(name ? name : "");
}
/// The level of all loggers that have none of their own.
inline void rcutils_logging_set_default_logger_level(int level)
{
  rcutils_logging_set_logger_level("", level ? level : RCUTILS_DEFAULT_LOGGER_DEFAULT_LEVEL);
}
inline int rcutils_logging_get_default_logger_level() {return rcutils_logging_get_logger_effective_level("");}

typedef struct rcutils_log_location_t
{
  const char * function_name;
  const char * file_name;
  size_t line_number;
} rcutils_log_location_t;
/// Gets each line that is shown: its place, level, logger, time in nanoseconds, and what printf would be given.
typedef void (* rcutils_logging_output_handler_t)(
  const rcutils_log_location_t * location, int severity, const char * name, int64_t timestamp, const char * format,
  va_list * args);
rcutils_logging_output_handler_t rcutils_logging_get_output_handler();
void rcutils_logging_set_output_handler(rcutils_logging_output_handler_t handler);
/// The handler that there is from the beginning: the line goes to the terminal, to the log file and to /rosout.
void rcutils_logging_console_output_handler(
  const rcutils_log_location_t * location, int severity, const char * name, int64_t timestamp, const char * format,
  va_list * args);
/// A line of one's own, where the logger shows its level; the location may be null.
void rcutils_log(const rcutils_log_location_t * location, int severity, const char * name, const char * format, ...)
#ifdef __GNUC__
__attribute__((format(printf, 4, 5)))
#endif
;
/// Whether a program has asked for logging. It works before, too.
extern bool g_rcutils_logging_initialized;
inline rcutils_ret_t rcutils_logging_initialize_with_allocator(rcutils_allocator_t allocator)
{
  bool valid = rcutils_allocator_is_valid(&allocator);
  g_rcutils_logging_initialized = g_rcutils_logging_initialized || valid;
  return valid ? RCUTILS_RET_OK : RCUTILS_RET_INVALID_ARGUMENT;
}
inline rcutils_ret_t rcutils_logging_initialize()
{
  return rcutils_logging_initialize_with_allocator(rcutils_get_default_allocator());
}
inline rcutils_ret_t rcutils_logging_shutdown()
{
  g_rcutils_logging_initialized = false;
  return RCUTILS_RET_OK;
}
#define RCUTILS_LOGGING_AUTOINIT do {(void)rcutils_logging_initialize();} while (0)
