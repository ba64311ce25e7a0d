// Loggers are names.
#pragma once
#include <memory>
#include <string>

#include "rcpputils/filesystem_helper.hpp"

namespace rclcpp
{
class Logger
{
public:
  enum class Level {Unset = 0, Debug = 10, Info = 20, Warn = 30, Error = 40, Fatal = 50};
  explicit Logger(std::string name)
  : name_(std::make_shared<const std::string>(std::move(name))) {}
  /// Its name; the text lives as long as any copy of the logger.
  const char * get_name() const {return name_->c_str();}
  Logger get_child(const std::string & suffix) const
  {
    return Logger(name_->empty() ? suffix : *name_ + "." + suffix);
  }
  void set_level(Level level);
  Level get_effective_level() const;

private:
  std::shared_ptr<const std::string> name_;
};
inline Logger get_logger(const std::string & name) {return Logger(name);}
/// Where log files go: $ROS_LOG_DIR, else log in $ROS_HOME, else ~/.ros/log.
rcpputils::fs::path get_logging_directory();
}  // namespace rclcpp
