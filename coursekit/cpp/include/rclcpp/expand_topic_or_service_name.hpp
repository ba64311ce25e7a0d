// Names of topics and services in full.
#pragma once
#include <string>

#include "rclcpp/exceptions.hpp"

namespace rclcpp
{
/// The name of a topic or service in full, as a node of that name and namespace would use it, before remapping.
/// Throws InvalidTopicNameError, InvalidServiceNameError, InvalidNodeNameError or InvalidNamespaceError.
std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & namespace_, bool is_service = false);
}  // namespace rclcpp
