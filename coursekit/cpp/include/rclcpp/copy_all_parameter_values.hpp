// A node's parameters for another node, such as one that works for it.
#pragma once
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
/// Declare at `destination` what `source` has and it has not; set what both have only where that is asked for.
template<class Source, class Destination>
void copy_all_parameter_values(const Source & source, const Destination & destination, const bool override_existing_params = false)
{
  auto from = source->get_node_parameters_interface();
  auto to = destination->get_node_parameters_interface();
  auto logger = destination->get_node_logging_interface()->get_logger();
  for (auto & name : from->list_parameters({}, 0).names) {
    const Parameter one = from->get_parameter(name);
    if (!to->has_parameter(name)) {
      to->declare_parameter(name, one.get_parameter_value(), from->describe_parameter(name));
    } else if (override_existing_params) {
      auto result = to->set_parameters_atomically({one});
      if (!result.successful) {
        RCLCPP_WARN(logger, "Unable to set parameter (%s): %s!", name.c_str(), result.reason.c_str());
      }
    }
  }
}
}  // namespace rclcpp
