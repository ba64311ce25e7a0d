// A node without children.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/tree_node.h"

namespace BT
{
class LeafNode : public TreeNode
{
public:
  LeafNode(const std::string & name, const NodeConfiguration & config)
  : TreeNode(name, config) {}
};
}  // namespace BT
