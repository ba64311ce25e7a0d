// All nodes that come with the library, and what goes through those of a tree.
#pragma once
#include <functional>
#include <iostream>
#include <type_traits>
#include <utility>
#include <vector>

#include "behaviortree_cpp_v3/action_node.h"
#include "behaviortree_cpp_v3/actions/always_failure_node.h"
#include "behaviortree_cpp_v3/actions/always_success_node.h"
#include "behaviortree_cpp_v3/actions/set_blackboard_node.h"
#include "behaviortree_cpp_v3/condition_node.h"
#include "behaviortree_cpp_v3/controls/fallback_node.h"
#include "behaviortree_cpp_v3/controls/if_then_else_node.h"
#include "behaviortree_cpp_v3/controls/parallel_node.h"
#include "behaviortree_cpp_v3/controls/reactive_fallback.h"
#include "behaviortree_cpp_v3/controls/reactive_sequence.h"
#include "behaviortree_cpp_v3/controls/sequence_node.h"
#include "behaviortree_cpp_v3/controls/sequence_star_node.h"
#include "behaviortree_cpp_v3/controls/switch_node.h"
#include "behaviortree_cpp_v3/controls/while_do_else_node.h"
#include "behaviortree_cpp_v3/decorators/blackboard_precondition.h"
#include "behaviortree_cpp_v3/decorators/delay_node.h"
#include "behaviortree_cpp_v3/decorators/force_failure_node.h"
#include "behaviortree_cpp_v3/decorators/force_success_node.h"
#include "behaviortree_cpp_v3/decorators/inverter_node.h"
#include "behaviortree_cpp_v3/decorators/keep_running_until_failure_node.h"
#include "behaviortree_cpp_v3/decorators/repeat_node.h"
#include "behaviortree_cpp_v3/decorators/retry_node.h"
#include "behaviortree_cpp_v3/decorators/subtree_node.h"
#include "behaviortree_cpp_v3/decorators/timeout_node.h"

namespace BT
{
/// Visit a node, and then those below it. Throws LogicError where a child is missing.
void applyRecursiveVisitor(const TreeNode * root_node, const std::function<void(const TreeNode *)> & visitor);
void applyRecursiveVisitor(TreeNode * root_node, const std::function<void(TreeNode *)> & visitor);
void printTreeRecursively(const TreeNode * root_node, std::ostream & stream = std::cout);

using SerializedTreeStatus = std::vector<std::pair<uint16_t, uint8_t>>;
void buildSerializedStatusSnapshot(TreeNode * root_node, SerializedTreeStatus & serialized_buffer);

template<class T>
constexpr NodeType getType()
{
  if constexpr (std::is_base_of_v<ActionNodeBase, T>) {
    return NodeType::ACTION;
  } else if constexpr (std::is_base_of_v<ConditionNode, T>) {
    return NodeType::CONDITION;
  } else if constexpr (std::is_base_of_v<SubtreeNode, T> || std::is_base_of_v<SubtreePlusNode, T>) {
    return NodeType::SUBTREE;
  } else if constexpr (std::is_base_of_v<DecoratorNode, T>) {
    return NodeType::DECORATOR;
  } else if constexpr (std::is_base_of_v<ControlNode, T>) {
    return NodeType::CONTROL;
  }
  return NodeType::UNDEFINED;
}
}  // namespace BT
