// The level of OpenCV's own log. Nothing logs here: the level is only kept, for programs that set and read it.
#pragma once

namespace cv::utils::logging
{
enum LogLevel
{
  LOG_LEVEL_SILENT, LOG_LEVEL_FATAL, LOG_LEVEL_ERROR, LOG_LEVEL_WARNING, LOG_LEVEL_INFO, LOG_LEVEL_DEBUG, LOG_LEVEL_VERBOSE
};
namespace detail
{
inline LogLevel & level()
{
  static LogLevel kept = LOG_LEVEL_WARNING;
  return kept;
}
}  // namespace detail
inline LogLevel getLogLevel() {return detail::level();}
/// Set the level. Returns the level before.
inline LogLevel setLogLevel(LogLevel level)
{
  const LogLevel before = detail::level();
  detail::level() = level;
  return before;
}
}  // namespace cv::utils::logging
