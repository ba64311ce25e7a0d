// A node of a tree that cancels all goals of an action's server.
#pragma once
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "behaviortree_cpp_v3/action_node.h"
#include "nav2_behavior_tree/ros_of_tree.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree
{
template<class ActionT>
class BtCancelActionNode : public BT::ActionNodeBase, protected RosOfTree
{
public:
  BtCancelActionNode(
    const std::string & xml_tag_name, const std::string & action_name, const BT::NodeConfiguration & conf)
  : ActionNodeBase(xml_tag_name, conf), RosOfTree(static_cast<const BT::TreeNode &>(*this)), action_name_(action_name)
  {
    getInput("server_name", action_name_);
    createActionClient(action_name_);
    RCLCPP_DEBUG(node_->get_logger(), "\"%s\" BtCancelActionNode initialized", xml_tag_name.c_str());
  }
  BtCancelActionNode() = delete;

  /// Throws std::runtime_error where the server does not appear within a second.
  void createActionClient(const std::string & action_name) {action_client_ = client_of<ActionT>(action_name);}
  static BT::PortsList providedBasicPorts(BT::PortsList addition)
  {
    return with_server_ports(std::move(addition), "server_name", "Action server name");
  }
  static BT::PortsList providedPorts() {return providedBasicPorts({});}

  void halt() override {}
  BT::NodeStatus tick() override
  {
    setStatus(BT::NodeStatus::RUNNING);
    auto canceled = action_client_->async_cancel_goals_before(node_->now());
    if (callback_group_executor_.spin_until_future_complete(canceled, server_timeout_) !=
      rclcpp::FutureReturnCode::SUCCESS)
    {
      RCLCPP_ERROR(node_->get_logger(), "Failed to cancel the action server for %s", action_name_.c_str());
      return BT::NodeStatus::FAILURE;
    }
    return BT::NodeStatus::SUCCESS;
  }

protected:
  std::string action_name_;
  typename rclcpp_action::Client<ActionT>::SharedPtr action_client_;
};
}  // namespace nav2_behavior_tree
