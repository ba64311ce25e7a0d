// Ticks all of its children from the first at each tick; one that runs has the others halted.
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

  /// Whether LogicError is thrown when another child runs than before; it is not at first.
  static void EnableException(bool enable);
  void halt() override;

private:
  NodeStatus tick() override;

  static bool throw_if_multiple_running_;
  int running_ = -1;
};
}  // namespace BT
