// How much OpenCV itself says: a part of it that is not here says nothing, so that the level is only kept.
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
/// Set it; what it was before.
inline LogLevel setLogLevel(LogLevel level)
{
  const LogLevel before = detail::level();
  detail::level() = level;
  return before;
}
}  // namespace cv::utils::logging
