// A container of one's own: components are loaded from their libraries, or run as programs where there is no library.
#include "rclcpp_components/component_manager.hpp"

#include <fstream>
#include <sstream>

#include "ament_index_cpp/get_resource.hpp"

namespace rclcpp_components
{
namespace
{
constexpr char FACTORY[] = "rclcpp_components::NodeFactoryTemplate<";

std::vector<std::string> split(const std::string & text, char by)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, by); ) {
    if (!part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}
bool is_library(const std::string & path)
{
  for (auto suffix : {".so", ".dylib", ".dll"}) {
    size_t length = std::string(suffix).size();
    if (path.size() > length && path.compare(path.size() - length, length, suffix) == 0) {
      return true;
    }
  }
  return false;
}

/// Runs a component's own program, which is the session's: its node is not one of this program.
class ProgramFactory : public NodeFactory
{
public:
  explicit ProgramFactory(std::string path)
  : path_(std::move(path)) {}
  NodeInstanceWrapper create_node_instance(const rclcpp::NodeOptions & options) override
  {
    rclcpp::Packer with = rclcpp::Packer{}.s(path_).i(static_cast<int64_t>(options.arguments().size()));
    for (auto & word : options.arguments()) {
      with.s(word);
    }
    auto & parameters = options.parameter_overrides();
    with.i(static_cast<int64_t>(parameters.size()));
    for (auto & parameter : parameters) {
      with.m(parameter.to_parameter_msg());
    }
    auto program = std::make_shared<coursekit::Entity>();
    auto base = std::make_shared<rclcpp::node_interfaces::NodeBaseInterface>();
    rclcpp::Unpacker answer = rclcpp::ask("component", with);
    program->id = answer.i();
    base->full_name = answer.s();
    return NodeInstanceWrapper(program, [base](auto &) {return base;});
  }

private:
  std::string path_;
};
}  // namespace

ComponentManager::ComponentManager(
  std::weak_ptr<rclcpp::Executor> executor, std::string node_name, const rclcpp::NodeOptions & node_options)
: Node(std::move(node_name), node_options), executor_(executor)
{
  using namespace std::placeholders;  // NOLINT
  loadNode_srv_ = create_service<LoadNode>(
    "~/_container/load_node", std::bind(&ComponentManager::on_load_node, this, _1, _2, _3));
  unloadNode_srv_ = create_service<UnloadNode>(
    "~/_container/unload_node", std::bind(&ComponentManager::on_unload_node, this, _1, _2, _3));
  listNodes_srv_ = create_service<ListNodes>(
    "~/_container/list_nodes", std::bind(&ComponentManager::on_list_nodes, this, _1, _2, _3));
}
ComponentManager::~ComponentManager()
{
  if (auto exec = executor_.lock()) {
    for (auto & entry : node_wrappers_) {
      auto base = entry.second.get_node_base_interface();
      if (base->id && base->in_executor) {
        exec->remove_node(base);
      }
    }
  }
}

std::vector<ComponentManager::ComponentResource> ComponentManager::get_component_resources(
  const std::string & package_name, const std::string & resource_index) const
{
  std::string content, base_path;
  if (!ament_index_cpp::get_resource(resource_index, package_name, content, &base_path)) {
    throw ComponentManagerException("Could not find requested resource in ament index");
  }
  std::vector<ComponentResource> resources;
  for (auto & line : split(content, '\n')) {
    auto parts = split(line, ';');
    if (parts.size() < 2) {
      throw ComponentManagerException("Invalid resource entry");
    }
    std::string path = parts[1];
    if (parts.size() > 2 && std::ifstream(base_path + "/" + parts[2])) {
      path = parts[2];
    }
    resources.emplace_back(parts[0], path.front() == '/' ? path : base_path + "/" + path);
  }
  return resources;
}
std::shared_ptr<NodeFactory> ComponentManager::create_component_factory(const ComponentResource & resource)
{
  const std::string & path = resource.second;
  auto & loader = loaders_[path];
  if (!loader) {
    RCLCPP_INFO(get_logger(), "Load Library: %s", path.c_str());
    try {
      loader = std::make_unique<class_loader::ClassLoader>(is_library(path) ? path : "");
    } catch (const std::exception & error) {
      loaders_.erase(path);
      throw ComponentManagerException("Failed to load library: " + std::string(error.what()));
    }
  }
  const std::string wanted = FACTORY + resource.first + ">";
  auto classes = is_library(path) ? loader->getAvailableClasses<NodeFactory>() : std::vector<std::string>{wanted};
  for (auto & name : classes) {
    RCLCPP_INFO(get_logger(), "Found class: %s", name.c_str());
    if (name == resource.first || name == wanted) {
      RCLCPP_INFO(get_logger(), "Instantiate class: %s", name.c_str());
      return is_library(path) ? loader->createInstance<NodeFactory>(name) : std::make_shared<ProgramFactory>(path);
    }
  }
  return nullptr;
}
rclcpp::NodeOptions ComponentManager::create_node_options(const std::shared_ptr<LoadNode::Request> request)
{
  std::vector<rclcpp::Parameter> parameters;
  for (auto & message : request->parameters) {
    parameters.push_back(rclcpp::Parameter::from_parameter_msg(message));
  }
  std::vector<std::string> words{"--ros-args"};
  auto rules = request->remap_rules;
  if (!request->node_name.empty()) {
    rules.push_back("__node:=" + request->node_name);
  }
  if (!request->node_namespace.empty()) {
    rules.push_back("__ns:=" + request->node_namespace);
  }
  for (auto & rule : rules) {
    words.push_back("-r");
    words.push_back(rule);
  }
  auto options = rclcpp::NodeOptions().use_global_arguments(false).parameter_overrides(parameters).arguments(words);
  for (auto & message : request->extra_arguments) {
    auto extra = rclcpp::Parameter::from_parameter_msg(message);
    if (extra.get_name() != "use_intra_process_comms") {
      continue;
    }
    if (extra.get_type() != rclcpp::ParameterType::PARAMETER_BOOL) {
      throw ComponentManagerException("Extra component argument 'use_intra_process_comms' must be a boolean");
    }
    options.use_intra_process_comms(extra.as_bool());
  }
  return options;
}
void ComponentManager::add_node_to_executor(uint64_t node_id)
{
  auto exec = executor_.lock();
  if (exec && is_here(node_id)) {
    exec->add_node(node_wrappers_[node_id].get_node_base_interface(), true);
  }
}
void ComponentManager::remove_node_from_executor(uint64_t node_id)
{
  auto exec = executor_.lock();
  if (exec && is_here(node_id)) {
    exec->remove_node(node_wrappers_[node_id].get_node_base_interface());
  }
}

// -- the services

NodeInstanceWrapper ComponentManager::make_instance(NodeFactory & factory, const rclcpp::NodeOptions & options)
{
  try {
    return factory.create_node_instance(options);
  } catch (const std::exception & error) {
    throw ComponentManagerException("Component constructor threw an exception: " + std::string(error.what()));
  } catch (...) {
    throw ComponentManagerException("Component constructor threw an exception");
  }
}
void ComponentManager::load(const LoadNode::Request::SharedPtr & request, LoadNode::Response & response)
{
  for (auto & resource : get_component_resources(request->package_name)) {
    if (resource.first != request->plugin_name) {
      continue;
    }
    auto factory = create_component_factory(resource);
    if (!factory) {
      continue;
    }
    auto options = create_node_options(request);
    uint64_t node_id = unique_id_++;
    if (node_id == 0) {
      throw std::overflow_error("exhausted the unique ids for components in this process");
    }
    node_wrappers_[node_id] = make_instance(*factory, options);
    add_node_to_executor(node_id);
    response.full_node_name = node_wrappers_[node_id].get_node_base_interface()->get_fully_qualified_name();
    response.unique_id = node_id;
    response.success = true;
    return;
  }
  RCLCPP_ERROR(
    get_logger(), "Failed to find class with the requested plugin name '%s' in the loaded library", request->plugin_name.c_str());
  response.error_message = "Failed to find class with the requested plugin name.";
}
void ComponentManager::on_load_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<LoadNode::Request> request,
  std::shared_ptr<LoadNode::Response> response)
{
  try {
    load(request, *response);
  } catch (const ComponentManagerException & error) {
    RCLCPP_ERROR(get_logger(), "%s", error.what());
    response->error_message = error.what();
    response->success = false;
  }
}
void ComponentManager::on_unload_node(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<UnloadNode::Request> request,
  std::shared_ptr<UnloadNode::Response> response)
{
  auto wrapper = node_wrappers_.find(request->unique_id);
  if (wrapper == node_wrappers_.end()) {
    response->success = false;
    response->error_message = "No node found with unique_id: " + std::to_string(request->unique_id);
    RCLCPP_WARN(get_logger(), "%s", response->error_message.c_str());
    return;
  }
  remove_node_from_executor(request->unique_id);
  node_wrappers_.erase(wrapper);
  response->success = true;
}
void ComponentManager::on_list_nodes(
  const std::shared_ptr<rmw_request_id_t>, const std::shared_ptr<ListNodes::Request>,
  std::shared_ptr<ListNodes::Response> response)
{
  for (auto & entry : node_wrappers_) {
    response->unique_ids.push_back(entry.first);
    response->full_node_names.push_back(entry.second.get_node_base_interface()->get_fully_qualified_name());
  }
}
}  // namespace rclcpp_components
