// Waits for some time before it ticks its child.
#pragma once
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"
#include "behaviortree_cpp_v3/decorators/alarm.h"

namespace BT
{
class DelayNode : public DecoratorNode
{
public:
  DelayNode(const std::string & name, unsigned milliseconds)
  : DecoratorNode(name, {}), milliseconds_(milliseconds), alarm_([this] {emitStateChanged();})
  {
    setRegistrationID("Delay");
  }
  DelayNode(const std::string & name, const NodeConfiguration & config)
  : DecoratorNode(name, config), read_ports_(true), alarm_([this] {emitStateChanged();}) {}
  static PortsList providedPorts();
  void halt() override;

private:
  NodeStatus tick() override;

  unsigned milliseconds_ = 0;
  bool read_ports_ = false;
  bool started_ = false;
  Alarm alarm_;
};
}  // namespace BT
