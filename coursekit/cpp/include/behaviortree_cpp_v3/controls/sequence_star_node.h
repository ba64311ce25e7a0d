// Ticks its children in their order until one fails; then it goes on with that one.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class SequenceStarNode : public ControlNode
{
public:
  explicit SequenceStarNode(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("SequenceStar");}
  void halt() override;

private:
  NodeStatus tick() override;

  size_t current_ = 0;
};
}  // namespace BT
