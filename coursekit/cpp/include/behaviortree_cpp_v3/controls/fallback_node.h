// Ticks its children in their order until one succeeds.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class FallbackNode : public ControlNode
{
public:
  explicit FallbackNode(const std::string & name)
  : ControlNode(name, {}) {setRegistrationID("Fallback");}
  void halt() override;

private:
  NodeStatus tick() override;

  size_t current_ = 0;
};
}  // namespace BT
