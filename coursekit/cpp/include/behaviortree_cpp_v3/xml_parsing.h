// Trees from XML, and the models of nodes as XML.
#pragma once
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "behaviortree_cpp_v3/bt_factory.h"
#include "behaviortree_cpp_v3/bt_parser.h"

namespace BT
{
class XMLParser : public Parser
{
public:
  explicit XMLParser(const BehaviorTreeFactory & factory);
  ~XMLParser() override;

  /// Throws RuntimeError that tells the line.
  void loadFromFile(const std::string & filename, bool add_includes = true) override;
  void loadFromText(const std::string & xml_text, bool add_includes = true) override;
  std::vector<std::string> registeredBehaviorTrees() const override;
  /// The main tree where none is named.
  Tree instantiateTree(const Blackboard::Ptr & root_blackboard, std::string main_tree_to_execute = {}) override;
  void clearInternalState() override;

private:
  struct Pimpl;
  std::unique_ptr<Pimpl> _p;
};

/// Throws RuntimeError where a text is no description of trees of such nodes.
void VerifyXML(const std::string & xml_text, const std::unordered_map<std::string, NodeType> & registered_nodes);
/// The ports of a factory's nodes, as editors of trees read them.
std::string writeTreeNodesModelXML(const BehaviorTreeFactory & factory, bool include_builtin = false);

Tree buildTreeFromText(const BehaviorTreeFactory & factory, const std::string & text, const Blackboard::Ptr & blackboard);
Tree buildTreeFromFile(
  const BehaviorTreeFactory & factory, const std::string & filename, const Blackboard::Ptr & blackboard);
}  // namespace BT
