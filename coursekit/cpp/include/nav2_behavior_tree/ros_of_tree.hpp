// What the nodes of trees that ask servers have: the blackboard's node, and callbacks that only they spin.
#pragma once
#include <algorithm>
#include <chrono>
#include <memory>

#include "behaviortree_cpp_v3/tree_node.h"
#include "nav2_behavior_tree/bt_conversions.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_behavior_tree
{
class RosOfTree
{
protected:
  /// Throws BT::RuntimeError where the blackboard has no node, or one of the times is missing.
  explicit RosOfTree(const BT::TreeNode & of)
  : node_(of.config().blackboard->get<rclcpp::Node::SharedPtr>("node")),
    callback_group_(node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false)),
    bt_loop_duration_(of.config().blackboard->get<std::chrono::milliseconds>("bt_loop_duration")),
    server_timeout_(of.config().blackboard->get<std::chrono::milliseconds>("server_timeout"))
  {
    callback_group_executor_.add_callback_group(callback_group_, node_->get_node_base_interface());
    of.getInput("server_timeout", server_timeout_);
  }

  /// Spin until a future has its value, but no longer than a loop of the tree, nor than the rest of the server's time.
  template<class Future>
  rclcpp::FutureReturnCode spin_until(const Future & future, std::chrono::milliseconds elapsed)
  {
    const auto rest = std::min(server_timeout_ - elapsed, bt_loop_duration_);
    return rest.count() <= 0 ? rclcpp::FutureReturnCode::TIMEOUT :
           callback_group_executor_.spin_until_future_complete(future, rest);
  }
  std::chrono::milliseconds since(const rclcpp::Time & time) const
  {
    return (node_->now() - time).template to_chrono<std::chrono::milliseconds>();
  }

  rclcpp::Node::SharedPtr node_;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp::executors::SingleThreadedExecutor callback_group_executor_;
  std::chrono::milliseconds bt_loop_duration_;
  std::chrono::milliseconds server_timeout_;
};

/// Count a recovery in the blackboard.
inline void count_recovery(BT::Blackboard & blackboard)
{
  int count = 0;
  blackboard.get("number_recoveries", count);
  blackboard.set<int>("number_recoveries", count + 1);
}
}  // namespace nav2_behavior_tree
