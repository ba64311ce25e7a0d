// Ticks its child again when it has failed, so many times; -1 is without end.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"

namespace BT
{
class RetryNode : public DecoratorNode
{
public:
  RetryNode(const std::string & name, int NTries)
  : DecoratorNode(name, {}), attempts_(NTries) {setRegistrationID("RetryUntilSuccessful");}
  RetryNode(const std::string & name, const NodeConfiguration & config)
  : DecoratorNode(name, config), read_ports_(true) {}
  static PortsList providedPorts();
  void halt() override;

private:
  NodeStatus tick() override;
  NodeStatus end(NodeStatus status);

  int attempts_ = 0;
  int done_ = 0;
  bool read_ports_ = false;
};

/// By the name with the misspelling that it had at first.
class RetryNodeTypo : public RetryNode
{
public:
  using RetryNode::RetryNode;
};
}  // namespace BT
