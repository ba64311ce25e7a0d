// What the nodes of trees that ask servers have: the blackboard's node, and callbacks that only they spin.
#pragma once
#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "behaviortree_cpp_v3/tree_node.h"
#include "nav2_behavior_tree/bt_conversions.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

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

  /// A client of an action whose server is there. Throws std::runtime_error where none appears within a second.
  template<class ActionT>
  typename rclcpp_action::Client<ActionT>::SharedPtr client_of(const std::string & action_name)
  {
    auto client = rclcpp_action::create_client<ActionT>(node_, action_name, callback_group_);
    RCLCPP_DEBUG(node_->get_logger(), "Waiting for \"%s\" action server", action_name.c_str());
    if (!client->wait_for_action_server(std::chrono::seconds(1))) {
      RCLCPP_ERROR(
        node_->get_logger(), "\"%s\" action server not available after waiting for 1 s", action_name.c_str());
      throw std::runtime_error("Action server " + action_name + " not available");
    }
    return client;
  }
  /// The ports of a node that asks a server, besides its own.
  static BT::PortsList with_server_ports(
    BT::PortsList ports, const std::string & name, const std::string & description)
  {
    ports.insert(BT::InputPort<std::string>(name, description));
    ports.insert(BT::InputPort<std::chrono::milliseconds>("server_timeout"));
    return ports;
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
