// A node that was made, whatever its class.
#pragma once
#include <functional>
#include <memory>

#include "rclcpp/rclcpp.hpp"

namespace rclcpp_components
{
class NodeInstanceWrapper
{
public:
  using NodeBaseInterface = rclcpp::node_interfaces::NodeBaseInterface;
  using NodeBaseInterfaceGetter = std::function<NodeBaseInterface::SharedPtr (const std::shared_ptr<void> &)>;
  NodeInstanceWrapper() = default;
  /// The node, and what gets its base interface.
  NodeInstanceWrapper(std::shared_ptr<void> node, NodeBaseInterfaceGetter getter)
  : node_(std::move(node)), getter_(std::move(getter)) {}
  std::shared_ptr<void> get_node_instance() {return node_;}
  NodeBaseInterface::SharedPtr get_node_base_interface() {return getter_(node_);}

private:
  std::shared_ptr<void> node_;
  NodeBaseInterfaceGetter getter_;
};
}  // namespace rclcpp_components
