// The interfaces of a node. rclcpp has ten classes of them; here one object is all ten.
#pragma once
#include "rclcpp/callback_group.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/logger.hpp"

namespace rclcpp::node_interfaces
{
class NodeBaseInterface
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeBaseInterface)
  virtual ~NodeBaseInterface();
  const char * get_name() const {return name.c_str();}
  const char * get_namespace() const {return space.c_str();}
  const char * get_fully_qualified_name() const {return full_name.c_str();}
  Context::SharedPtr get_context() {return context;}
  CallbackGroup::SharedPtr get_default_callback_group() {return group;}
  Logger get_logger() const {return logger;}
  const char * get_logger_name() const {return logger.get_name();}
  Clock::SharedPtr get_clock() {return clock;}
  Clock::ConstSharedPtr get_clock() const {return clock;}
  NodeBaseInterface * operator->() {return this;}

  int64_t id = 0;
  std::string name, space, full_name;
  Logger logger{""};
  CallbackGroup::SharedPtr group;
  Clock::SharedPtr clock;
  Context::SharedPtr context = contexts::get_global_default_context();
  bool in_executor = false, topic_statistics = false, intra_process = false;
};
using NodeClockInterface = NodeBaseInterface;
using NodeGraphInterface = NodeBaseInterface;
using NodeLoggingInterface = NodeBaseInterface;
using NodeParametersInterface = NodeBaseInterface;
using NodeServicesInterface = NodeBaseInterface;
using NodeTimersInterface = NodeBaseInterface;
using NodeTimeSourceInterface = NodeBaseInterface;
using NodeTopicsInterface = NodeBaseInterface;
using NodeWaitablesInterface = NodeBaseInterface;

struct OnSetParametersCallbackHandle : coursekit::Entity
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
};
}  // namespace rclcpp::node_interfaces
