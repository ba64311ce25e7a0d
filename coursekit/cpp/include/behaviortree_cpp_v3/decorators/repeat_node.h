// Ticks its child again when it has succeeded, so many times; -1 is without end.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class RepeatNode : public DecoratorNode
{
public:
  RepeatNode(const std::string & name, int NTries)
  : DecoratorNode(name, {}), cycles_(NTries) {setRegistrationID("Repeat");}
  RepeatNode(const std::string & name, const NodeConfiguration & config)
  : DecoratorNode(name, config), read_ports_(true) {}
  static PortsList providedPorts();
  void halt() override;

private:
  NodeStatus tick() override;
  NodeStatus end(NodeStatus status);

  int cycles_ = 0;
  int done_ = 0;
  bool read_ports_ = false;
};
}  // namespace BT
