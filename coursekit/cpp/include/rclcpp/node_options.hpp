// Options of nodes.
#pragma once
#include "rcl/node_options.h"
#include "rclcpp/parameter.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/utilities.hpp"
#include "rcutils/allocator.h"

namespace rclcpp
{
class NodeOptions
{
public:
  NodeOptions() = default;
  NodeOptions(const rcl_allocator_t & allocator)  // NOLINT: implicit, as Humble's
  : allocator_(allocator) {}
#define COURSEKIT_OPTION(Type, name, default_value) \
  NodeOptions & name(const Type & value) {name ## _ = value; return *this;} \
  const Type & name() const {return name ## _;} \
private: \
  Type name ## _ = default_value; \
public:
  COURSEKIT_OPTION(std::vector<std::string>, arguments, {})
  COURSEKIT_OPTION(std::vector<Parameter>, parameter_overrides, {})
  COURSEKIT_OPTION(bool, use_global_arguments, true)
  COURSEKIT_OPTION(bool, allow_undeclared_parameters, false)
  COURSEKIT_OPTION(bool, automatically_declare_parameters_from_overrides, false)
  COURSEKIT_OPTION(bool, enable_rosout, true)
  COURSEKIT_OPTION(bool, use_intra_process_comms, false)
  COURSEKIT_OPTION(bool, enable_topic_statistics, false)
  COURSEKIT_OPTION(bool, start_parameter_services, true)
  COURSEKIT_OPTION(bool, start_parameter_event_publisher, true)
  COURSEKIT_OPTION(bool, use_clock_thread, true)
  COURSEKIT_OPTION(QoS, clock_qos, ClockQoS())
  COURSEKIT_OPTION(QoS, parameter_event_qos, ParameterEventsQoS())
  COURSEKIT_OPTION(QoS, rosout_qos, RosoutQoS())
  COURSEKIT_OPTION(rcl_allocator_t, allocator, rcl_get_default_allocator())
  COURSEKIT_OPTION(PublisherOptionsBase, parameter_event_publisher_options, {})
  template<class T>
  NodeOptions & append_parameter_override(const std::string & name, const T & value)
  {
    parameter_overrides_.emplace_back(name, ParameterValue(value));
    return *this;
  }
  std::vector<Parameter> & parameter_overrides() {return parameter_overrides_;}
  NodeOptions & context(Context::SharedPtr context)
  {
    context_ = context;
    return *this;
  }
  const rcl_node_options_t * get_rcl_node_options() const
  {
    rcl_ = {allocator_, use_global_arguments_, enable_rosout_, rosout_qos_.get_rmw_qos_profile()};
    return &rcl_;
  }
  Context::SharedPtr context() const {return context_ ? context_ : contexts::get_global_default_context();}

private:
  mutable rcl_node_options_t rcl_{};
  Context::SharedPtr context_;
};
}  // namespace rclcpp
