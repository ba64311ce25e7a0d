// The components that a program has, by the names of their classes.
#include <map>

#include "rclcpp_components/node_factory.hpp"

namespace rclcpp_components
{
namespace
{
std::map<std::string, std::shared_ptr<NodeFactory>> & factories()
{
  static std::map<std::string, std::shared_ptr<NodeFactory>> known;
  return known;
}
std::string without_spaces(const std::string & name)
{
  std::string plain;
  for (char c : name) {
    if (c != ' ') {
      plain += c;
    }
  }
  return plain.rfind("::", 0) == 0 ? plain.substr(2) : plain;
}
}  // namespace

bool enter(const std::string & plugin, std::shared_ptr<NodeFactory> factory)
{
  return factories().emplace(without_spaces(plugin), std::move(factory)).second;
}
std::vector<std::string> factory_names()
{
  std::vector<std::string> names;
  for (auto & entry : factories()) {
    names.push_back(entry.first);
  }
  return names;
}
std::shared_ptr<NodeFactory> factory_called(const std::string & plugin)
{
  auto found = factories().find(without_spaces(plugin));
  return found == factories().end() ? nullptr : found->second;
}
NodeInstanceWrapper make(const std::string & plugin, const rclcpp::NodeOptions & options)
{
  auto found = factories().find(without_spaces(plugin));
  if (found == factories().end()) {
    throw std::runtime_error(
            "Failed to find class with the requested plugin name. It is " + plugin + ": is RCLCPP_COMPONENTS_REGISTER_NODE(" + plugin +
            ") in a source of its library?");
  }
  return found->second->create_node_instance(options);
}
}  // namespace rclcpp_components
