// The names of levels, and the level of one logger, in C.
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
