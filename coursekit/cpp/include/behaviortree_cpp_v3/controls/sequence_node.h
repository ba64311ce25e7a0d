// Ticks its children in their order until one fails; then it begins again with the first.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class SequenceNode : public ControlNode
{
public:
  explicit SequenceNode(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("Sequence");}
  void halt() override;

private:
  NodeStatus tick() override;

  size_t current_ = 0;
};
}  // namespace BT
