// A node with one child.
#pragma once
#include <functional>
#include <string>
#include <utility>

#include "behaviortree_cpp_v3/tree_node.h"

namespace BT
{
class DecoratorNode : public TreeNode
{
public:
  DecoratorNode(const std::string & name, const NodeConfiguration & config)
  : TreeNode(name, config) {}

  /// Throws BehaviorTreeException for a second one.
  void setChild(TreeNode * child);
  const TreeNode * child() const {return child_node_;}
  TreeNode * child() {return child_node_;}
  NodeType type() const override {return NodeType::DECORATOR;}

  void halt() override;
  void haltChild();
  void resetChild() {haltChild();}
  NodeStatus executeTick() override;

protected:
  TreeNode * child_node_ = nullptr;
};

class SimpleDecoratorNode : public DecoratorNode
{
public:
  using TickFunctor = std::function<NodeStatus(NodeStatus, TreeNode &)>;

  SimpleDecoratorNode(const std::string & name, TickFunctor tick_functor, const NodeConfiguration & config)
  : DecoratorNode(name, config), tick_functor_(std::move(tick_functor)) {}

protected:
  NodeStatus tick() override {return tick_functor_(child()->executeTick(), *this);}

  TickFunctor tick_functor_;
};
}  // namespace BT
