// Failure, whatever the child's end.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class ForceFailureNode : public DecoratorNode
{
public:
  explicit ForceFailureNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("ForceFailure");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
