// Ticks the child whose case is the variable's value, or else the last one.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/control_node.h"

namespace BT
{
class SwitchNodeBase : public ControlNode
{
public:
  SwitchNodeBase(const std::string & name, const NodeConfiguration & config, size_t cases)
  : ControlNode(name, config), cases_(cases) {setRegistrationID("Switch");}
  void halt() override;

protected:
  static PortsList ports(size_t cases);

private:
  NodeStatus tick() override;
  size_t chosen() const;

  size_t cases_;
  int running_ = -1;
};

template<size_t NUM_CASES>
class SwitchNode : public SwitchNodeBase
{
public:
  SwitchNode(const std::string & name, const NodeConfiguration & config)
  : SwitchNodeBase(name, config, NUM_CASES) {}
  static PortsList providedPorts() {return ports(NUM_CASES);}
};
}  // namespace BT
