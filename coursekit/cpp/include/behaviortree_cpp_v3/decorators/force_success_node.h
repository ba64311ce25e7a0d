// Success, whatever the child's end.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class ForceSuccessNode : public DecoratorNode
{
public:
  explicit ForceSuccessNode(const std::string & name)
  : DecoratorNode(name, {}) {setRegistrationID("ForceSuccess");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
