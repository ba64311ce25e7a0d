// What makes nodes of one class.
#pragma once
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components
{
template<class N>
class NodeFactoryTemplate : public NodeFactory
{
public:
  NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options) override
  {
    auto node = std::make_shared<N>(options);
    return NodeInstanceWrapper(node, std::bind(&N::get_node_base_interface, node));
  }
};
}  // namespace rclcpp_components
