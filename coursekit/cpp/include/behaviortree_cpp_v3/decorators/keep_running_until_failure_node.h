// Ticks its child again and again until it fails.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class KeepRunningUntilFailureNode : public DecoratorNode
{
public:
  explicit KeepRunningUntilFailureNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("KeepRunningUntilFailure");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
