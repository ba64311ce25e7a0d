// The nodes of trees that choose a child, or tick all of them together.
#include <algorithm>
#include <stdexcept>

#include "behaviortree_cpp_v3/controls/if_then_else_node.h"
#include "behaviortree_cpp_v3/controls/parallel_node.h"
#include "behaviortree_cpp_v3/controls/switch_node.h"
#include "behaviortree_cpp_v3/controls/while_do_else_node.h"
#include "bt_ticked.hpp"

namespace BT
{
ParallelNode::ParallelNode(const std::string & name, int success_threshold, int failure_threshold)
: ControlNode(name, {}), success_threshold_(success_threshold), failure_threshold_(failure_threshold)
{
  setRegistrationID("Parallel");
}
PortsList ParallelNode::providedPorts()
{
  return {
    InputPort<int>("success_threshold", "number of childen which need to succeed to trigger a SUCCESS"),
    InputPort<int>("failure_threshold", 1, "number of childen which need to fail to trigger a FAILURE")};
}
size_t ParallelNode::counted(int threshold) const
{
  const int count = static_cast<int>(childrenCount());
  return static_cast<size_t>(threshold < 0 ? std::max(count + threshold + 1, 0) : threshold);
}
void ParallelNode::check_thresholds()
{
  if (read_ports_ && !getInput("success_threshold", success_threshold_)) {
    throw RuntimeError("Missing parameter [success_threshold] in ParallelNode");
  }
  if (read_ports_ && !getInput("failure_threshold", failure_threshold_)) {
    throw RuntimeError("Missing parameter [failure_threshold] in ParallelNode");
  }
  if (childrenCount() < successThreshold()) {
    throw LogicError("Number of children is less than threshold. Can never succeed.");
  }
  if (childrenCount() < failureThreshold()) {
    throw LogicError("Number of children is less than threshold. Can never fail.");
  }
}
NodeStatus ParallelNode::tick()
{
  check_thresholds();
  size_t succeeded = 0, failed = 0;
  for (size_t i = 0; i < childrenCount(); ++i) {
    TreeNode & child = *children_nodes_[i];
    const NodeStatus status = finished_.count(i) ? child.status() : ticked(child);
    if (StatusCompleted(status)) {
      finished_.insert(i);
    }
    succeeded += status == NodeStatus::SUCCESS;
    failed += status == NodeStatus::FAILURE;
    if (status == NodeStatus::SUCCESS && succeeded == successThreshold()) {
      return end(status);
    }
    const bool lost = failed > childrenCount() - successThreshold() || failed == failureThreshold();
    if (status == NodeStatus::FAILURE && lost) {
      return end(status);
    }
  }
  return NodeStatus::RUNNING;
}
NodeStatus ParallelNode::end(NodeStatus status)
{
  finished_.clear();
  haltChildren();
  return status;
}
void ParallelNode::halt()
{
  finished_.clear();
  ControlNode::halt();
}

NodeStatus IfThenElseNode::tick()
{
  if (childrenCount() != 2 && childrenCount() != 3) {
    throw std::logic_error("IfThenElseNode must have either 2 or 3 children");
  }
  setStatus(NodeStatus::RUNNING);
  if (current_ == 0) {
    const NodeStatus condition = ticked(*children_nodes_[0]);
    if (condition == NodeStatus::RUNNING) {
      return condition;
    }
    current_ = condition == NodeStatus::SUCCESS ? 1 : 2;
  }
  const NodeStatus status = current_ < childrenCount() ? ticked(*children_nodes_[current_]) : NodeStatus::FAILURE;
  if (status != NodeStatus::RUNNING) {
    haltChildren();
    current_ = 0;
  }
  return status;
}
void IfThenElseNode::halt()
{
  current_ = 0;
  ControlNode::halt();
}

NodeStatus WhileDoElseNode::tick()
{
  if (childrenCount() != 3) {
    throw std::logic_error("WhileDoElse must have 3 children");
  }
  setStatus(NodeStatus::RUNNING);
  const NodeStatus condition = ticked(*children_nodes_[0]);
  if (condition == NodeStatus::RUNNING) {
    return condition;
  }
  const size_t chosen = condition == NodeStatus::SUCCESS ? 1 : 2;
  haltChild(3 - chosen);
  const NodeStatus status = ticked(*children_nodes_[chosen]);
  if (status != NodeStatus::RUNNING) {
    haltChildren();
  }
  return status;
}

PortsList SwitchNodeBase::ports(size_t cases)
{
  PortsList all = {InputPort<std::string>("variable")};
  for (size_t i = 1; i <= cases; ++i) {
    all.insert(InputPort<std::string>("case_" + std::to_string(i)));
  }
  return all;
}
size_t SwitchNodeBase::chosen() const
{
  std::string variable, value;
  for (size_t i = 0; getInput("variable", variable) && i < cases_; ++i) {
    if (getInput("case_" + std::to_string(i + 1), value) && value == variable) {
      return i;
    }
  }
  return cases_;
}
NodeStatus SwitchNodeBase::tick()
{
  if (childrenCount() != cases_ + 1) {
    throw LogicError("Wrong number of children in SwitchNode; must be (num_cases + default)");
  }
  const int index = static_cast<int>(chosen());
  if (running_ != -1 && running_ != index) {
    haltChild(static_cast<size_t>(running_));
  }
  const NodeStatus status = ticked(*children_nodes_[static_cast<size_t>(index)]);
  running_ = status == NodeStatus::RUNNING ? index : -1;
  if (running_ == -1) {
    haltChildren();
  }
  return status;
}
void SwitchNodeBase::halt()
{
  running_ = -1;
  ControlNode::halt();
}
}  // namespace BT
