// The names of levels, the level of one logger, and a line of its own, in C.
#include "coursekit/link.hpp"
#include "rclcpp/exceptions.hpp"
#include "rcutils/logging.h"

#define COURSEKIT_SEVERITY(name) \
  name, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr

const char * const g_rcutils_log_severity_names[RCUTILS_LOG_SEVERITY_FATAL + 1] = {
  COURSEKIT_SEVERITY("UNSET"), COURSEKIT_SEVERITY("DEBUG"), COURSEKIT_SEVERITY("INFO"), COURSEKIT_SEVERITY("WARN"),
  COURSEKIT_SEVERITY("ERROR"), "FATAL"};
int rcutils_logging_get_logger_level(const char * name)
{
  return name ? static_cast<int>(rclcpp::ask("logger_level", rclcpp::Packer{}.s(name)).i()) : -1;
}
bool g_rcutils_logging_initialized = false;
void rcutils_log(const rcutils_log_location_t * location, int severity, const char * name, const char * format, ...)
{
  if (!rcutils_logging_logger_is_enabled_for(name, severity)) {
    return;
  }
  va_list args;
  va_start(args, format);
  rcutils_logging_get_output_handler()(location, severity, name ? name : "", coursekit::system_now(), format, &args);
  va_end(args);
}
