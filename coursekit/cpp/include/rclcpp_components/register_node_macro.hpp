#pragma once
#include "rclcpp_components/node_factory.hpp"

/// Enter a class of nodes among the components of a library.
#define RCLCPP_COMPONENTS_REGISTER_NODE(NodeClass) COURSEKIT_REGISTER(NodeClass, __COUNTER__)
#define COURSEKIT_REGISTER(NodeClass, n) COURSEKIT_REGISTER_(NodeClass, n)
#define COURSEKIT_REGISTER_(NodeClass, n) \
  namespace {[[maybe_unused]] const bool coursekit_entered_ ## n = rclcpp_components::enter( \
    #NodeClass, std::make_shared<rclcpp_components::NodeFactoryTemplate<NodeClass>>());}
