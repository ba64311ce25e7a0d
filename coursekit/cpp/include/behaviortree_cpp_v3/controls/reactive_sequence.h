// Ticks all of its children from the first at each tick; one that runs has those behind it halted.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class ReactiveSequence : public ControlNode
{
public:
  explicit ReactiveSequence(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("ReactiveSequence");}

private:
  NodeStatus tick() override;
};
}  // namespace BT
