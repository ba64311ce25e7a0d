// Names of nodes and topics, and parameters that others may have declared already.
#pragma once
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace nav2_util
{
/// A name with _ in place of what node names cannot have.
std::string sanitize_node_name(const std::string & potential_node_name);
/// Both names with one / between them.
std::string add_namespaces(const std::string & top_ns, const std::string & sub_ns = "");
std::string generate_internal_node_name(const std::string & prefix = "");
rclcpp::Node::SharedPtr generate_internal_node(const std::string & prefix = "");
/// Random digits, as many as wanted.
std::string time_to_string(size_t len);

template<typename NodeT>
void declare_parameter_if_not_declared(
  NodeT node, const std::string & param_name, const rclcpp::ParameterValue & default_value,
  const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor = rcl_interfaces::msg::ParameterDescriptor())
{
  if (!node->has_parameter(param_name)) {
    node->declare_parameter(param_name, default_value, parameter_descriptor);
  }
}
template<typename NodeT>
void declare_parameter_if_not_declared(
  NodeT node, const std::string & param_name, const rclcpp::ParameterType & param_type,
  const rcl_interfaces::msg::ParameterDescriptor & parameter_descriptor = rcl_interfaces::msg::ParameterDescriptor())
{
  if (!node->has_parameter(param_name)) {
    node->declare_parameter(param_name, param_type, parameter_descriptor);
  }
}

/// The type that the parameters give to a plugin; ends the program where they give none.
template<typename NodeT>
std::string get_plugin_type_param(NodeT node, const std::string & plugin_name)
{
  const std::string parameter = plugin_name + ".plugin";
  declare_parameter_if_not_declared(node, parameter, rclcpp::PARAMETER_STRING);
  std::string type;
  try {
    if (node->get_parameter(parameter, type)) {
      return type;
    }
    RCLCPP_FATAL(node->get_logger(), "Can not get 'plugin' param value for %s", plugin_name.c_str());
  } catch (const rclcpp::exceptions::ParameterUninitializedException &) {
    RCLCPP_FATAL(node->get_logger(), "'plugin' param not defined for %s", plugin_name.c_str());
  }
  exit(-1);
}
}  // namespace nav2_util
