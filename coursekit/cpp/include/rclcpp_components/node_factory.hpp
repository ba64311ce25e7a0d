// Components: classes of nodes that a program can make by their names.
#pragma once
#include "class_loader/class_loader.hpp"
#include "rclcpp/rclcpp.hpp"

namespace rclcpp_components
{
/// A node that was made, whatever its class.
class NodeInstanceWrapper
{
public:
  NodeInstanceWrapper() = default;
  NodeInstanceWrapper(std::shared_ptr<void> node, rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base)
  : node_(std::move(node)), base_(std::move(base)) {}
  std::shared_ptr<void> get_node_instance() {return node_;}
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr get_node_base_interface() {return base_;}

private:
  std::shared_ptr<void> node_;
  rclcpp::node_interfaces::NodeBaseInterface::SharedPtr base_;
};

class NodeFactory
{
public:
  virtual ~NodeFactory() = default;
  virtual NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options) = 0;
};

template<class N>
class NodeFactoryTemplate : public NodeFactory
{
public:
  NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options) override
  {
    auto node = std::make_shared<N>(options);
    return {node, node->get_node_base_interface()};
  }
};

/// main() of a program that has one component and spins it in the executor E.
template<class E>
int run(const std::string & plugin, int argc, char ** argv);
NodeInstanceWrapper make(const std::string & plugin, const rclcpp::NodeOptions & options);

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
