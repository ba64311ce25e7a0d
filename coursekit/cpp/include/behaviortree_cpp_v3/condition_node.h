// Conditions: they are asked, and never halted.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "behaviortree_cpp_v3/leaf_node.h"

namespace BT
{
class ConditionNode : public LeafNode
{
public:
  ConditionNode(const std::string & name, const NodeConfiguration & config)
  : LeafNode(name, config) {}
  void halt() final {resetStatus();}
  NodeType type() const final {return NodeType::CONDITION;}
};

class SimpleConditionNode : public ConditionNode
{
public:
  using TickFunctor = std::function<NodeStatus(TreeNode &)>;

  SimpleConditionNode(const std::string & name, TickFunctor tick_functor, const NodeConfiguration & config)
  : ConditionNode(name, config), tick_functor_(std::move(tick_functor)) {}

protected:
  NodeStatus tick() override {return tick_functor_(*this);}

  TickFunctor tick_functor_;
};
}  // namespace BT
