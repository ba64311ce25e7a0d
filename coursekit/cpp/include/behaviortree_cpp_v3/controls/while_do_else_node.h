// The first child chooses at each tick between the second and the third.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class WhileDoElseNode : public ControlNode
{
public:
  explicit WhileDoElseNode(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("WhileDoElse");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
