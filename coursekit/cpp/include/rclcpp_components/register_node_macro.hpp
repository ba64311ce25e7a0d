#pragma once
#include "rclcpp_components/node_factory.hpp"

/// Enter a class of nodes among the components of a library.
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) \
  CLASS_LOADER_REGISTER_CLASS(rclcpp_components::NodeFactoryTemplate<NodeClass>, rclcpp_components::NodeFactory)
