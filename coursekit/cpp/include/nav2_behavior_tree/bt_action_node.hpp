// A node of a tree that has the server of an action do it.
#pragma once
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "action_msgs/msg/goal_status.hpp"
#include "behaviortree_cpp_v3/action_node.h"
#include "nav2_behavior_tree/ros_of_tree.hpp"
#include "nav2_util/node_utils.hpp"
#include "rclcpp_action/rclcpp_action.hpp"

namespace nav2_behavior_tree
{
template<class ActionT>
class BtActionNode : public BT::ActionNodeBase, protected RosOfTree
{
public:
  using Handle = rclcpp_action::ClientGoalHandle<ActionT>;

  BtActionNode(const std::string & xml_tag_name, const std::string & action_name, const BT::NodeConfiguration & conf)
  : ActionNodeBase(xml_tag_name, conf), RosOfTree(static_cast<const BT::TreeNode &>(*this)), action_name_(action_name)
  {
    getInput("server_name", action_name_);
    createActionClient(action_name_);
    RCLCPP_DEBUG(node_->get_logger(), "\"%s\" BtActionNode initialized", xml_tag_name.c_str());
  }
  BtActionNode() = delete;

  /// Throws std::runtime_error where the server does not appear within a second.
  void createActionClient(const std::string & action_name) {action_client_ = client_of<ActionT>(action_name);}
  static BT::PortsList providedBasicPorts(BT::PortsList addition)
  {
    return with_server_ports(std::move(addition), "server_name", "Action server name");
  }
  static BT::PortsList providedPorts() {return providedBasicPorts({});}

  /// Fill in goal_, or have none sent: should_send_goal_.
  virtual void on_tick() {}
  /// Called at each tick until there is a result; goal_updated_ has goal_ sent again.
  virtual void on_wait_for_result(std::shared_ptr<const typename ActionT::Feedback>) {}
  virtual BT::NodeStatus on_success() {return BT::NodeStatus::SUCCESS;}
  virtual BT::NodeStatus on_aborted() {return BT::NodeStatus::FAILURE;}
  virtual BT::NodeStatus on_cancelled() {return BT::NodeStatus::SUCCESS;}

  BT::NodeStatus tick() override
  {
    if (status() == BT::NodeStatus::IDLE) {
      setStatus(BT::NodeStatus::RUNNING);
      should_send_goal_ = true;
      on_tick();
      if (!should_send_goal_) {
        return BT::NodeStatus::FAILURE;
      }
      send_new_goal();
    }
    try {
      const BT::NodeStatus waiting = wait();
      return waiting == BT::NodeStatus::IDLE ? ended() : waiting;
    } catch (const Refused &) {
      return BT::NodeStatus::FAILURE;
    }
  }
  /// Cancel the goal that the server is at.
  void halt() override
  {
    if (should_cancel_goal()) {
      auto canceled = action_client_->async_cancel_goal(goal_handle_);
      if (callback_group_executor_.spin_until_future_complete(canceled, server_timeout_) !=
        rclcpp::FutureReturnCode::SUCCESS)
      {
        RCLCPP_ERROR(node_->get_logger(), "Failed to cancel action server for %s", action_name_.c_str());
      }
    }
    setStatus(BT::NodeStatus::IDLE);
  }

protected:
  bool should_cancel_goal()
  {
    if (status() != BT::NodeStatus::RUNNING) {
      return false;
    }
    callback_group_executor_.spin_some();
    return goal_handle_ && is_active();
  }
  void send_new_goal()
  {
    goal_result_available_ = false;
    typename rclcpp_action::Client<ActionT>::SendGoalOptions options;
    options.result_callback = [this](const typename Handle::WrappedResult & result) {
        const bool of_an_older_goal = sent_ || !goal_handle_ || goal_handle_->get_goal_id() != result.goal_id;
        if (!of_an_older_goal) {
          goal_result_available_ = true;
          result_ = result;
        }
      };
    options.feedback_callback =
      [this](typename Handle::SharedPtr, const std::shared_ptr<const typename ActionT::Feedback> feedback) {
        feedback_ = feedback;
      };
    future_goal_handle_ = action_client_->async_send_goal(goal_, options);
    sent_ = true;
    time_goal_sent_ = node_->now();
  }
  void increment_recovery_count() {count_recovery(*config().blackboard);}

  std::string action_name_;
  typename rclcpp_action::Client<ActionT>::SharedPtr action_client_;
  typename ActionT::Goal goal_;
  bool goal_updated_ = false;
  bool goal_result_available_ = false;
  typename Handle::SharedPtr goal_handle_;
  typename Handle::WrappedResult result_;
  std::shared_ptr<const typename ActionT::Feedback> feedback_;
  bool should_send_goal_ = true;
  rclcpp::Time time_goal_sent_;

private:
  struct Refused {};

  bool is_active() const
  {
    const auto status = goal_handle_->get_status();
    return status == action_msgs::msg::GoalStatus::STATUS_ACCEPTED ||
           status == action_msgs::msg::GoalStatus::STATUS_EXECUTING;
  }
  /// IDLE when there is a result.
  BT::NodeStatus wait()
  {
    const BT::NodeStatus answer = wait_for_answer();
    if (answer != BT::NodeStatus::IDLE) {
      return answer;
    }
    if (!rclcpp::ok() || goal_result_available_) {
      return BT::NodeStatus::IDLE;
    }
    on_wait_for_result(feedback_);
    feedback_.reset();
    if (goal_updated_ && is_active()) {
      goal_updated_ = false;
      send_new_goal();
      const BT::NodeStatus again = wait_for_answer();
      if (again != BT::NodeStatus::IDLE) {
        return again;
      }
    }
    callback_group_executor_.spin_some();
    return goal_result_available_ ? BT::NodeStatus::IDLE : BT::NodeStatus::RUNNING;
  }
  /// IDLE when the server has accepted the goal. Throws Refused where it has not.
  BT::NodeStatus wait_for_answer()
  {
    if (!sent_) {
      return BT::NodeStatus::IDLE;
    }
    const auto code = spin_until(future_goal_handle_, since(time_goal_sent_));
    if (code == rclcpp::FutureReturnCode::SUCCESS) {
      sent_ = false;
      goal_handle_ = future_goal_handle_.get();
      return goal_handle_ ? BT::NodeStatus::IDLE : throw Refused();
    }
    if (code == rclcpp::FutureReturnCode::INTERRUPTED) {
      sent_ = false;
      throw Refused();
    }
    if (since(time_goal_sent_) < server_timeout_) {
      return BT::NodeStatus::RUNNING;
    }
    RCLCPP_WARN(
      node_->get_logger(), "Timed out while waiting for action server to acknowledge goal request for %s",
      action_name_.c_str());
    sent_ = false;
    return BT::NodeStatus::FAILURE;
  }
  BT::NodeStatus ended()
  {
    goal_handle_.reset();
    switch (result_.code) {
      case rclcpp_action::ResultCode::SUCCEEDED:
        return on_success();
      case rclcpp_action::ResultCode::ABORTED:
        return on_aborted();
      case rclcpp_action::ResultCode::CANCELED:
        return on_cancelled();
      default:
        throw std::logic_error("BtActionNode::Tick: invalid status value");
    }
  }

  std::shared_future<typename Handle::SharedPtr> future_goal_handle_;
  bool sent_ = false;
};
}  // namespace nav2_behavior_tree
