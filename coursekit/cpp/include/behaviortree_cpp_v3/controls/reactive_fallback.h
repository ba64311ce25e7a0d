// Tries all of its children from the first at each tick; one that runs has those behind it halted.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class ReactiveFallback : public ControlNode
{
public:
  explicit ReactiveFallback(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("ReactiveFallback");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
