// The components that a program has, by the names of their classes.
#include "class_loader/class_loader.hpp"
#include "rclcpp_components/coursekit_run.hpp"

namespace rclcpp_components
{
namespace
{
/// A class's name as all may write it: without spaces, and without the leading colons of the global namespace.
std::string plain(const std::string & name)
{
  std::string without;
  for (char c : name) {
    if (c != ' ') {
      without += c;
    }
  }
  return without.rfind("::", 0) == 0 ? without.substr(2) : without;
}
/// The plugin whose factory has that name: NodeFactoryTemplate<it>.
std::string plugin_of(const std::string & factory)
{
  size_t begin = factory.find('<') + 1;
  return plain(factory.substr(begin, factory.rfind('>') - begin));
}
}  // namespace

NodeInstanceWrapper make(const std::string & plugin, const rclcpp::NodeOptions & options)
{
  class_loader::ClassLoader own("");
  for (auto & name : own.getAvailableClasses<NodeFactory>()) {
    if (plugin_of(name) == plain(plugin)) {
      return own.createInstance<NodeFactory>(name)->create_node_instance(options);
    }
  }
  throw std::runtime_error(
          "Failed to find class with the requested plugin name. It is " + plugin + ": is RCLCPP_COMPONENTS_REGISTER_NODE(" + plugin +
          ") in a source of its library?");
}
}  // namespace rclcpp_components
