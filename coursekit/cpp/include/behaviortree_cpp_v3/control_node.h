// A node that chooses which of its children is ticked.
#pragma once
#include <string>
#include <vector>

#include "behaviortree_cpp_v3/tree_node.h"

namespace BT
{
class ControlNode : public TreeNode
{
public:
  ControlNode(const std::string & name, const NodeConfiguration & config)
  : TreeNode(name, config) {}

  void addChild(TreeNode * child) {children_nodes_.push_back(child);}
  size_t childrenCount() const {return children_nodes_.size();}
  const std::vector<TreeNode *> & children() const {return children_nodes_;}
  const TreeNode * child(size_t index) const {return children().at(index);}
  NodeType type() const final {return NodeType::CONTROL;}

  void halt() override;
  /// Halt those that run, and have all of them begin anew.
  void haltChildren();
  void resetChildren() {haltChildren();}
  void haltChild(size_t index);

protected:
  std::vector<TreeNode *> children_nodes_;
};
}  // namespace BT
