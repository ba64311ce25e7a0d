// Hears each change of a node's status in a tree.
#pragma once
#include <array>
#include <vector>

#include "behaviortree_cpp_v3/behavior_tree.h"
#include "behaviortree_cpp_v3/bt_factory.h"

namespace BT
{
enum class TimestampType
{
  ABSOLUTE,
  RELATIVE
};
using SerializedTransition = std::array<uint8_t, 12>;

class StatusChangeLogger
{
public:
  explicit StatusChangeLogger(TreeNode * root_node);
  virtual ~StatusChangeLogger() = default;

  virtual void callback(Duration timestamp, const TreeNode & node, NodeStatus prev_status, NodeStatus status) = 0;
  virtual void flush() = 0;
  void setEnabled(bool enabled) {enabled_ = enabled;}
  bool enabled() const {return enabled_;}
  void seTimestampType(TimestampType type) {type_ = type;}
  bool showsTransitionToIdle() const {return show_transition_to_idle_;}
  void enableTransitionToIdle(bool enable) {show_transition_to_idle_ = enable;}

private:
  void hear(TimePoint when, const TreeNode & node, NodeStatus before, NodeStatus status);

  bool enabled_ = true;
  bool show_transition_to_idle_ = true;
  std::vector<TreeNode::StatusChangeSubscriber> subscribers_;
  TimestampType type_ = TimestampType::ABSOLUTE;
  TimePoint begin_ = std::chrono::high_resolution_clock::now();
};
}  // namespace BT
