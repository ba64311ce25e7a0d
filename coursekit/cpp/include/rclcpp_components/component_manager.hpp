// A node that loads components when asked, and gives them to an executor.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "class_loader/class_loader.hpp"
#include "composition_interfaces/srv/list_nodes.hpp"
#include "composition_interfaces/srv/load_node.hpp"
#include "composition_interfaces/srv/unload_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components
{
/// A component cannot be found, loaded or made.
class ComponentManagerException : public std::runtime_error
{
public:
  explicit ComponentManagerException(const std::string & error_desc)
  : std::runtime_error(error_desc) {}
};

class ComponentManager : public rclcpp::Node
{
public:
  using LoadNode = composition_interfaces::srv::LoadNode;
  using UnloadNode = composition_interfaces::srv::UnloadNode;
  using ListNodes = composition_interfaces::srv::ListNodes;
  /// A class, and the library that has it, or the program that runs it where no library can be loaded.
  using ComponentResource = std::pair<std::string, std::string>;

  explicit ComponentManager(
    std::weak_ptr<rclcpp::Executor> executor = std::weak_ptr<rclcpp::executors::MultiThreadedExecutor>(),
    std::string node_name = "ComponentManager",
    const rclcpp::NodeOptions & node_options =
    rclcpp::NodeOptions().start_parameter_services(false).start_parameter_event_publisher(false));
  ~ComponentManager() override;

  /// What a package lists in the ament index; throws ComponentManagerException where it lists nothing.
  virtual std::vector<ComponentResource> get_component_resources(
    const std::string & package_name, const std::string & resource_index = "rclcpp_components") const;
  /// What makes nodes of a component; null where its library does not have it.
  virtual std::shared_ptr<NodeFactory> create_component_factory(const ComponentResource & resource);

protected:
  virtual rclcpp::NodeOptions create_node_options(const std::shared_ptr<LoadNode::Request> request);
  virtual void add_node_to_executor(uint64_t node_id);
  virtual void remove_node_from_executor(uint64_t node_id);
  virtual void on_load_node(
    const std::shared_ptr<rmw_request_id_t> request_header, const std::shared_ptr<LoadNode::Request> request,
    std::shared_ptr<LoadNode::Response> response);
  virtual void on_unload_node(
    const std::shared_ptr<rmw_request_id_t> request_header, const std::shared_ptr<UnloadNode::Request> request,
    std::shared_ptr<UnloadNode::Response> response);
  virtual void on_list_nodes(
    const std::shared_ptr<rmw_request_id_t> request_header, const std::shared_ptr<ListNodes::Request> request,
    std::shared_ptr<ListNodes::Response> response);
  void set_executor(const std::weak_ptr<rclcpp::Executor> executor) {executor_ = executor;}
  /// Whether a component runs in this program, so that an executor here serves it.
  bool is_here(uint64_t node_id) {return node_wrappers_[node_id].get_node_base_interface()->id != 0;}

  std::weak_ptr<rclcpp::Executor> executor_;
  uint64_t unique_id_{1};
  std::map<std::string, std::unique_ptr<class_loader::ClassLoader>> loaders_;
  std::map<uint64_t, NodeInstanceWrapper> node_wrappers_;
  rclcpp::Service<LoadNode>::SharedPtr loadNode_srv_;
  rclcpp::Service<UnloadNode>::SharedPtr unloadNode_srv_;
  rclcpp::Service<ListNodes>::SharedPtr listNodes_srv_;

private:
  void load(const LoadNode::Request::SharedPtr & request, LoadNode::Response & response);
  NodeInstanceWrapper make_instance(NodeFactory & factory, const rclcpp::NodeOptions & options);
};
}  // namespace rclcpp_components
