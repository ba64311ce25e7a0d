// The nodes of trees that have one child.
#include "behaviortree_cpp_v3/decorators/force_failure_node.h"
#include "behaviortree_cpp_v3/decorators/force_success_node.h"
#include "behaviortree_cpp_v3/decorators/inverter_node.h"
#include "behaviortree_cpp_v3/decorators/keep_running_until_failure_node.h"
#include "behaviortree_cpp_v3/decorators/repeat_node.h"
#include "behaviortree_cpp_v3/decorators/retry_node.h"
#include "behaviortree_cpp_v3/decorators/subtree_node.h"

namespace BT
{
NodeStatus InverterNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  const NodeStatus status = child()->executeTick();
  if (StatusCompleted(status)) {
    return status == NodeStatus::SUCCESS ? NodeStatus::FAILURE : NodeStatus::SUCCESS;
  }
  return status;
}
NodeStatus ForceSuccessNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  const NodeStatus status = child()->executeTick();
  return StatusCompleted(status) ? NodeStatus::SUCCESS : status;
}
NodeStatus ForceFailureNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  const NodeStatus status = child()->executeTick();
  return StatusCompleted(status) ? NodeStatus::FAILURE : status;
}
NodeStatus KeepRunningUntilFailureNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  return child()->executeTick() == NodeStatus::FAILURE ? NodeStatus::FAILURE : NodeStatus::RUNNING;
}

PortsList RepeatNode::providedPorts()
{
  return {InputPort<int>(
      "num_cycles", "Repeat a succesful child up to N times. Use -1 to create an infinite loop.")};
}
NodeStatus RepeatNode::tick()
{
  if (read_ports_ && !getInput("num_cycles", cycles_)) {
    throw RuntimeError("Missing parameter [num_cycles] in RepeatNode");
  }
  setStatus(NodeStatus::RUNNING);
  while (done_ < cycles_ || cycles_ == -1) {
    const NodeStatus status = child()->executeTick();
    if (!StatusCompleted(status)) {
      return status;
    }
    haltChild();
    if (status == NodeStatus::FAILURE) {
      return end(status);
    }
    ++done_;
  }
  return end(NodeStatus::SUCCESS);
}
NodeStatus RepeatNode::end(NodeStatus status)
{
  done_ = 0;
  return status;
}
void RepeatNode::halt()
{
  done_ = 0;
  DecoratorNode::halt();
}

PortsList RetryNode::providedPorts()
{
  return {InputPort<int>(
      "num_attempts", "Execute again a failing child up to N times. Use -1 to create an infinite loop.")};
}
NodeStatus RetryNode::tick()
{
  if (read_ports_ && !getInput("num_attempts", attempts_)) {
    throw RuntimeError("Missing parameter [num_attempts] in RetryNode");
  }
  setStatus(NodeStatus::RUNNING);
  while (done_ < attempts_ || attempts_ == -1) {
    const NodeStatus status = child()->executeTick();
    if (!StatusCompleted(status)) {
      return status;
    }
    haltChild();
    if (status == NodeStatus::SUCCESS) {
      return end(status);
    }
    ++done_;
  }
  return end(NodeStatus::FAILURE);
}
NodeStatus RetryNode::end(NodeStatus status)
{
  done_ = 0;
  return status;
}
void RetryNode::halt()
{
  done_ = 0;
  DecoratorNode::halt();
}

NodeStatus SubtreeNode::tick()
{
  if (status() == NodeStatus::IDLE) {
    setStatus(NodeStatus::RUNNING);
  }
  return child()->executeTick();
}
NodeStatus SubtreePlusNode::tick()
{
  if (status() == NodeStatus::IDLE) {
    setStatus(NodeStatus::RUNNING);
  }
  return child()->executeTick();
}
}  // namespace BT
