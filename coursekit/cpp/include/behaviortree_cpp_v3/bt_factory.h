// Makes nodes by their names, and trees of them.
#pragma once
#include <algorithm>
#include <cstring>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "behaviortree_cpp_v3/bt_parser.h"
#include "behaviortree_cpp_v3/tree.h"

namespace BT
{
using NodeBuilder = std::function<std::unique_ptr<TreeNode>(const std::string &, const NodeConfiguration &)>;

template<class T>
using has_default_constructor = std::is_constructible<T, const std::string &>;
template<class T>
using has_params_constructor = std::is_constructible<T, const std::string &, const NodeConfiguration &>;

/// A node without ports is made of its name alone where it can be.
template<class T>
NodeBuilder CreateBuilder()
{
  return [](const std::string & name, const NodeConfiguration & config) -> std::unique_ptr<TreeNode> {
           if constexpr (has_default_constructor<T>::value) {
             if (!has_params_constructor<T>::value || (config.input_ports.empty() && config.output_ports.empty())) {
               return std::make_unique<T>(name);
             }
           }
           if constexpr (has_params_constructor<T>::value) {
             return std::make_unique<T>(name, config);
           }
           return nullptr;
         };
}
template<class T>
TreeNodeManifest CreateManifest(const std::string & ID, PortsList ports = getProvidedPorts<T>())
{
  return {getType<T>(), ID, ports, {}};
}

constexpr const char * PLUGIN_SYMBOL = "BT_RegisterNodesFromPlugin";

/// The function that enters a library's nodes; the library is compiled with BT_PLUGIN_EXPORT.
#ifndef BT_PLUGIN_EXPORT
#define BT_REGISTER_NODES(factory) static void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory & factory)
#elif defined(_WIN32)
#define BT_REGISTER_NODES(factory) \
  extern "C" void __declspec(dllexport) BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory & factory)
#else
#define BT_REGISTER_NODES(factory) \
  extern "C" void __attribute__((visibility("default"))) BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory & factory)
#endif

class BehaviorTreeFactory
{
public:
  BehaviorTreeFactory();

  /// False where there is none. Throws LogicError for a node that comes with the library.
  bool unregisterBuilder(const std::string & ID);
  /// Throws BehaviorTreeException for a name that is taken.
  void registerBuilder(const TreeNodeManifest & manifest, const NodeBuilder & builder);
  template<class T>
  void registerBuilder(const std::string & ID, const NodeBuilder & builder) {registerBuilder(CreateManifest<T>(ID), builder);}

  void registerSimpleAction(
    const std::string & ID, const SimpleActionNode::TickFunctor & tick_functor, PortsList ports = {});
  void registerSimpleCondition(
    const std::string & ID, const SimpleConditionNode::TickFunctor & tick_functor, PortsList ports = {});
  void registerSimpleDecorator(
    const std::string & ID, const SimpleDecoratorNode::TickFunctor & tick_functor, PortsList ports = {});

  template<class T>
  void registerNodeType(const std::string & ID)
  {
    check<T>();
    constexpr bool has_ports = has_static_method_providedPorts<T>::value;
    static_assert(
      has_ports || !has_params_constructor<T>::value,
      "[registerNode]: you MUST implement the static method: PortsList providedPorts();");
    static_assert(
      !has_ports || has_params_constructor<T>::value,
      "[registerNode]: since you have a static method providedPorts(), you MUST add a constructor with the signature "
      "(const std::string&, const NodeConfiguration&)");
    registerBuilder(CreateManifest<T>(ID), CreateBuilder<T>());
  }
  template<class T>
  void registerNodeType(const std::string & ID, PortsList ports)
  {
    check<T>();
    static_assert(
      !has_static_method_providedPorts<T>::value,
      "[registerNode]: the ports are given here, so the static method providedPorts() must be removed");
    static_assert(
      has_params_constructor<T>::value,
      "[registerNode]: since this node has ports, you MUST add a constructor with the signature "
      "(const std::string&, const NodeConfiguration&)");
    registerBuilder(CreateManifest<T>(ID, ports), CreateBuilder<T>());
  }
  /// Enter the nodes of a library. Throws RuntimeError where it cannot be loaded.
  void registerFromPlugin(const std::string & file_path);
  /// Throws RuntimeError, as it does on ROS 2.
  void registerFromROSPlugins();

  void registerBehaviorTreeFromFile(const std::string & filename);
  void registerBehaviorTreeFromText(const std::string & xml_text);
  std::vector<std::string> registeredBehaviorTrees() const;
  void clearRegisteredBehaviorTrees();

  /// Throws RuntimeError for a name that is not known.
  std::unique_ptr<TreeNode> instantiateTreeNode(
    const std::string & name, const std::string & ID, const NodeConfiguration & config) const;
  const std::unordered_map<std::string, NodeBuilder> & builders() const {return builders_;}
  const std::unordered_map<std::string, TreeNodeManifest> & manifests() const {return manifests_;}
  const std::set<std::string> & builtinNodes() const {return builtin_;}
  void addDescriptionToManifest(const std::string & node_id, const std::string & description);

  Tree createTreeFromText(const std::string & text, Blackboard::Ptr blackboard = Blackboard::create());
  Tree createTreeFromFile(const std::string & file_path, Blackboard::Ptr blackboard = Blackboard::create());
  /// One of the registered trees.
  Tree createTree(const std::string & tree_name, Blackboard::Ptr blackboard = Blackboard::create());

private:
  template<class T>
  static constexpr void check()
  {
    static_assert(
      std::is_base_of_v<ActionNodeBase, T> || std::is_base_of_v<ControlNode, T> ||
      std::is_base_of_v<DecoratorNode, T> || std::is_base_of_v<ConditionNode, T>,
      "[registerNode]: accepts only classed derived from either ActionNodeBase, DecoratorNode, ControlNode or ConditionNode");
    static_assert(
      !std::is_abstract_v<T>,
      "[registerNode]: Some methods are pure virtual. Did you override the methods tick() and halt()?");
    static_assert(
      has_default_constructor<T>::value || has_params_constructor<T>::value,
      "[registerNode]: the registered class must have at least one of these two constructors: "
      "(const std::string&, const NodeConfiguration&) or (const std::string&)");
  }
  void register_controls();
  void register_decorators();
  void register_leaves();
  Tree create(Parser & parser, Blackboard::Ptr blackboard, const std::string & name) const;

  std::unordered_map<std::string, NodeBuilder> builders_;
  std::unordered_map<std::string, TreeNodeManifest> manifests_;
  std::set<std::string> builtin_;
  std::shared_ptr<Parser> parser_;
};
}  // namespace BT
