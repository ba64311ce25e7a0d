// What the nodes of trees that choose among their children have in common.
#pragma once
#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
inline NodeStatus ticked(TreeNode & child)
{
  const NodeStatus status = child.executeTick();
  return status == NodeStatus::IDLE ? throw LogicError("A child node must never return IDLE") : status;
}
}  // namespace BT
