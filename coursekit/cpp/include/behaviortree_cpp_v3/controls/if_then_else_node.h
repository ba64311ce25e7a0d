// The first child chooses once between the second and the third, if there is one.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class IfThenElseNode : public ControlNode
{
public:
  explicit IfThenElseNode(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("IfThenElse");}
  void halt() override;

private:
  NodeStatus tick() override;

  size_t current_ = 0;
};
}  // namespace BT
