// The nodes of trees that tick their children in order.
#include "behaviortree_cpp_v3/controls/fallback_node.h"
#include "behaviortree_cpp_v3/controls/reactive_fallback.h"
#include "behaviortree_cpp_v3/controls/reactive_sequence.h"
#include "behaviortree_cpp_v3/controls/sequence_node.h"
#include "behaviortree_cpp_v3/controls/sequence_star_node.h"
#include "bt_ticked.hpp"

namespace BT
{
namespace
{
void halt_all_but(ControlNode & node, size_t index)
{
  for (size_t i = 0; i < node.childrenCount(); ++i) {
    if (i != index) {
      node.haltChild(i);
    }
  }
}
/// Remember which child of a reactive node runs; throw where it is another one and that is asked for.
void check_running(const std::string & kind, bool throws, int & running, size_t index)
{
  const int now = static_cast<int>(index);
  if (running != -1 && running != now && throws) {
    throw LogicError(
            "[", kind, "]: only a single child can return RUNNING.\nThis throw can be disabled with ", kind,
            "::EnableException(false)");
  }
  running = running == -1 ? now : running;
}
}  // namespace

NodeStatus SequenceNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  for (; current_ < childrenCount(); ++current_) {
    const NodeStatus status = ticked(*children_nodes_[current_]);
    if (status == NodeStatus::FAILURE) {
      haltChildren();
      current_ = 0;
    }
    if (status != NodeStatus::SUCCESS) {
      return status;
    }
  }
  haltChildren();
  current_ = 0;
  return NodeStatus::SUCCESS;
}
void SequenceNode::halt()
{
  current_ = 0;
  ControlNode::halt();
}

NodeStatus SequenceStarNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  for (; current_ < childrenCount(); ++current_) {
    const NodeStatus status = ticked(*children_nodes_[current_]);
    for (size_t i = current_; status == NodeStatus::FAILURE && i < childrenCount(); ++i) {
      haltChild(i);
    }
    if (status != NodeStatus::SUCCESS) {
      return status;
    }
  }
  haltChildren();
  current_ = 0;
  return NodeStatus::SUCCESS;
}
void SequenceStarNode::halt()
{
  current_ = 0;
  ControlNode::halt();
}

NodeStatus FallbackNode::tick()
{
  setStatus(NodeStatus::RUNNING);
  for (; current_ < childrenCount(); ++current_) {
    const NodeStatus status = ticked(*children_nodes_[current_]);
    if (status == NodeStatus::SUCCESS) {
      haltChildren();
      current_ = 0;
    }
    if (status != NodeStatus::FAILURE) {
      return status;
    }
  }
  haltChildren();
  current_ = 0;
  return NodeStatus::FAILURE;
}
void FallbackNode::halt()
{
  current_ = 0;
  ControlNode::halt();
}

bool ReactiveSequence::throw_if_multiple_running_ = false;
void ReactiveSequence::EnableException(bool enable) {throw_if_multiple_running_ = enable;}

NodeStatus ReactiveSequence::tick()
{
  running_ = status() == NodeStatus::IDLE ? -1 : running_;
  setStatus(NodeStatus::RUNNING);
  for (size_t index = 0; index < childrenCount(); ++index) {
    const NodeStatus status = ticked(*children_nodes_[index]);
    if (status == NodeStatus::RUNNING) {
      halt_all_but(*this, index);
      check_running("ReactiveSequence", throw_if_multiple_running_, running_, index);
    } else if (status == NodeStatus::FAILURE) {
      haltChildren();
    }
    if (status != NodeStatus::SUCCESS) {
      return status;
    }
  }
  haltChildren();
  return NodeStatus::SUCCESS;
}
void ReactiveSequence::halt()
{
  running_ = -1;
  ControlNode::halt();
}

bool ReactiveFallback::throw_if_multiple_running_ = false;
void ReactiveFallback::EnableException(bool enable) {throw_if_multiple_running_ = enable;}

NodeStatus ReactiveFallback::tick()
{
  running_ = status() == NodeStatus::IDLE ? -1 : running_;
  setStatus(NodeStatus::RUNNING);
  for (size_t index = 0; index < childrenCount(); ++index) {
    const NodeStatus status = ticked(*children_nodes_[index]);
    if (status == NodeStatus::RUNNING) {
      halt_all_but(*this, index);
      check_running("ReactiveFallback", throw_if_multiple_running_, running_, index);
    } else if (status == NodeStatus::SUCCESS) {
      haltChildren();
    }
    if (status != NodeStatus::FAILURE) {
      return status;
    }
  }
  haltChildren();
  return NodeStatus::FAILURE;
}
void ReactiveFallback::halt()
{
  running_ = -1;
  ControlNode::halt();
}
}  // namespace BT
