#include "check.hpp"
#include "rcutils/logging.h"
#include "rcutils/logging_macros.h"

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = rclcpp::Node::make_shared("logging");
  auto logger = node->get_logger();
  check("info is the level", logger.get_effective_level() == rclcpp::Logger::Level::Info);
  logger.set_level(rclcpp::Logger::Level::Debug);
  check("a level is set", logger.get_effective_level() == rclcpp::Logger::Level::Debug);
  check("children have it", logger.get_child("arm").get_effective_level() == rclcpp::Logger::Level::Debug);
  throws<rclcpp::exceptions::RCLInvalidArgument>(
    "no level has that number", [&] {logger.set_level(static_cast<rclcpp::Logger::Level>(99));});
  int level = 0;
  equal("a level by its name", rcutils_logging_severity_level_from_string("warn", rcl_get_default_allocator(), &level), RCUTILS_RET_OK);
  equal("it is", level, static_cast<int>(RCUTILS_LOG_SEVERITY_WARN));
  equal("no such name", rcutils_logging_severity_level_from_string("loud", rcl_get_default_allocator(), &level),
    RCUTILS_RET_LOGGING_SEVERITY_STRING_INVALID);
  check("set in C", rcutils_logging_set_logger_level("logging", RCUTILS_LOG_SEVERITY_ERROR) == RCUTILS_RET_OK &&
    logger.get_effective_level() == rclcpp::Logger::Level::Error);
  equal("its own level in C", rcutils_logging_get_logger_level("logging"), static_cast<int>(RCUTILS_LOG_SEVERITY_ERROR));
  equal("a child has none of its own", rcutils_logging_get_logger_level("logging.arm"), 0);
  equal("all loggers' level in C", rcutils_logging_get_logger_level(""), static_cast<int>(RCUTILS_LOG_SEVERITY_INFO));
  equal("no logger has no level", rcutils_logging_get_logger_level(nullptr), -1);
  equal("a level's name", std::string(g_rcutils_log_severity_names[RCUTILS_LOG_SEVERITY_WARN]), "WARN");
  check("not enabled", !rcutils_logging_logger_is_enabled_for("logging", RCUTILS_LOG_SEVERITY_INFO));
  RCLCPP_INFO(logger, "LINE hidden");
  logger.set_level(rclcpp::Logger::Level::Info);
  RCLCPP_DEBUG(logger, "LINE hidden too");
  RCLCPP_INFO(logger, "LINE %d of %s", 1, "text");
  RCLCPP_WARN_STREAM(logger, "LINE stream " << 2 << ' ' << 0.5);
  for (int i = 0; i < 3; ++i) {
    RCLCPP_ERROR_ONCE(logger, "LINE once %d", i);
    RCLCPP_INFO_SKIPFIRST(logger, "LINE skipped first %d", i);
    RCLCPP_INFO_EXPRESSION(logger, i == 1, "LINE expression %d", i);
    RCLCPP_INFO_THROTTLE(logger, *node->get_clock(), 1000, "LINE throttled %d", i);
    RCLCPP_INFO_STREAM_THROTTLE(logger, *node->get_clock(), 1000, "LINE throttled stream " << i);
    RCLCPP_FATAL_STREAM_ONCE(logger, "LINE fatal " << i);
  }
  std::function<bool ()> yes = [] {return true;};
  RCLCPP_INFO_FUNCTION(logger, &yes, "LINE function");
  int evaluated = 0;
  std::function<bool ()> counting = [&] {return ++evaluated;};
  RCLCPP_DEBUG_FUNCTION(logger, &counting, "LINE of a function");
  RCLCPP_DEBUG(logger, "LINE %d", ++evaluated);
  RCLCPP_DEBUG_STREAM(logger, "LINE " << ++evaluated);
  RCLCPP_DEBUG_EXPRESSION(logger, ++evaluated, "LINE of an expression");
  equal("what is not shown is not evaluated", evaluated, 0);
  logger.set_level(rclcpp::Logger::Level::Debug);
  RCLCPP_DEBUG_FUNCTION(logger, &counting, "debugged");
  equal("what is shown is", evaluated, 1);
  const char * name = node->get_logger().get_name();
  std::string other = node->get_logger().get_child("a_name_of_another_logger").get_name();
  equal("a logger's name outlives its copies", std::string(name), std::string("logging"));
  RCUTILS_LOG_WARN_NAMED("named", "LINE by name");
  RCUTILS_LOG_WARN_EXPRESSION_NAMED(1 + 1 == 2, "named", "LINE by name %d", 2);
  for (int i = 0; i < 3; ++i) {
    RCUTILS_LOG_WARN_THROTTLE_NAMED(rcutils_steady_time_now, 60000, "named", "LINE throttled by name %d", i);
  }
  RCUTILS_LOG_WARN_EXPRESSION(1 + 1 == 3, "LINE never");
  rclcpp::shutdown();
}
