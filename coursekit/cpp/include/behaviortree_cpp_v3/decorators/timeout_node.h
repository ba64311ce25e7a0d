// Halts a child that has run for too long, and fails; 0 is as long as it wants.
#pragma once
#include <mutex>
#include <string>

#include "behaviortree_cpp_v3/decorator_node.h"
#include "behaviortree_cpp_v3/decorators/alarm.h"

namespace BT
{
class TimeoutNodeBase : public DecoratorNode
{
public:
  TimeoutNodeBase(const std::string & name, const NodeConfiguration & config, unsigned milliseconds, bool read_ports);
  void halt() override;

protected:
  static PortsList ports();

private:
  NodeStatus tick() override;
  void start();
  void ring();

  unsigned milliseconds_;
  bool read_ports_;
  bool started_ = false;
  std::recursive_mutex mutex_;  // a child may halt its tree
  Alarm alarm_;
};

/// The parameters are those of upstream; the time is that of the steady clock.
template<class Clock = std::chrono::steady_clock, class Time = typename Clock::duration>
class TimeoutNode : public TimeoutNodeBase
{
public:
  TimeoutNode(const std::string & name, unsigned milliseconds)
  : TimeoutNodeBase(name, {}, milliseconds, false) {}
  TimeoutNode(const std::string & name, const NodeConfiguration & config)
  : TimeoutNodeBase(name, config, 0, true) {}
  static PortsList providedPorts() {return ports();}
};
}  // namespace BT
