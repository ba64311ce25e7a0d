// Ticks its child as long as two values are equal.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
template<class T>
class BlackboardPreconditionNode : public DecoratorNode
{
public:
  BlackboardPreconditionNode(const std::string & name, const NodeConfiguration & config)
  : DecoratorNode(name, config) {}
  static PortsList providedPorts()
  {
    return {InputPort("value_A"), InputPort("value_B"), InputPort<NodeStatus>("return_on_mismatch")};
  }

private:
  NodeStatus tick() override
  {
    setStatus(NodeStatus::RUNNING);
    T a{}, b{};
    if (getInput("value_A", a) && getInput("value_B", b) && a == b) {
      return child()->executeTick();
    }
    haltChild();
    NodeStatus otherwise = NodeStatus::FAILURE;
    getInput("return_on_mismatch", otherwise);
    return otherwise;
  }
};
}  // namespace BT
