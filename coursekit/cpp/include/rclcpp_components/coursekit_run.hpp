// main() of a program that has one component.
#pragma once
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components
{
/// Make a component that the program is linked with; throws std::runtime_error where it has none of that name.
NodeInstanceWrapper make(const std::string & plugin, const rclcpp::NodeOptions & options);

/// Make it and spin it in the executor E.
template<class E>
int run(const std::string & plugin, int argc, char ** argv)
{
  rclcpp::NodeOptions options;
  options.arguments(rclcpp::init_and_remove_ros_arguments(argc, argv));
  E executor;
  NodeInstanceWrapper node = make(plugin, options);
  executor.add_node(node.get_node_base_interface());
  executor.spin();
  executor.remove_node(node.get_node_base_interface());
  rclcpp::shutdown();
  return 0;
}
}  // namespace rclcpp_components
