// A node of a tree that calls a service.
#pragma once
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "behaviortree_cpp_v3/action_node.h"
#include "nav2_behavior_tree/ros_of_tree.hpp"
#include "nav2_util/node_utils.hpp"

namespace nav2_behavior_tree
{
template<class ServiceT>
class BtServiceNode : public BT::ActionNodeBase, protected RosOfTree
{
public:
  /// Throws std::runtime_error where the service does not appear within a second.
  BtServiceNode(const std::string & service_node_name, const BT::NodeConfiguration & conf)
  : ActionNodeBase(service_node_name, conf), RosOfTree(static_cast<const BT::TreeNode &>(*this)),
    service_node_name_(service_node_name)
  {
    getInput("service_name", service_name_);
    service_client_ = node_->create_client<ServiceT>(service_name_, rmw_qos_profile_services_default, callback_group_);
    RCLCPP_DEBUG(node_->get_logger(), "Waiting for \"%s\" service", service_name_.c_str());
    if (!service_client_->wait_for_service(std::chrono::seconds(1))) {
      RCLCPP_ERROR(
        node_->get_logger(), "\"%s\" service server not available after waiting for 1 s", service_node_name.c_str());
      throw std::runtime_error("Service server " + service_node_name + " not available");
    }
    RCLCPP_DEBUG(node_->get_logger(), "\"%s\" BtServiceNode initialized", service_node_name_.c_str());
  }
  BtServiceNode() = delete;

  static BT::PortsList providedBasicPorts(BT::PortsList addition)
  {
    return with_server_ports(std::move(addition), "service_name", "please_set_service_name_in_BT_Node");
  }
  static BT::PortsList providedPorts() {return providedBasicPorts({});}

  /// Fill in request_, or have none sent: should_send_request_.
  virtual void on_tick() {}
  virtual BT::NodeStatus on_completion(std::shared_ptr<typename ServiceT::Response>) {return BT::NodeStatus::SUCCESS;}
  virtual void on_wait_for_result() {}

  BT::NodeStatus tick() override
  {
    if (!request_sent_) {
      should_send_request_ = true;
      on_tick();
      if (!should_send_request_) {
        return BT::NodeStatus::FAILURE;
      }
      future_result_ = service_client_->async_send_request(request_).future.share();
      sent_time_ = node_->now();
      request_sent_ = true;
    }
    return check_future();
  }
  void halt() override
  {
    request_sent_ = false;
    setStatus(BT::NodeStatus::IDLE);
  }
  virtual BT::NodeStatus check_future()
  {
    const auto code = spin_until(future_result_, since(sent_time_));
    if (code == rclcpp::FutureReturnCode::SUCCESS) {
      request_sent_ = false;
      return on_completion(future_result_.get());
    }
    if (code == rclcpp::FutureReturnCode::TIMEOUT && since(sent_time_) < server_timeout_) {
      on_wait_for_result();
      return BT::NodeStatus::RUNNING;
    }
    RCLCPP_WARN(
      node_->get_logger(), "Node timed out while executing service call to %s.", service_name_.c_str());
    request_sent_ = false;
    return BT::NodeStatus::FAILURE;
  }

protected:
  void increment_recovery_count() {count_recovery(*config().blackboard);}

  std::string service_name_, service_node_name_;
  typename std::shared_ptr<rclcpp::Client<ServiceT>> service_client_;
  std::shared_ptr<typename ServiceT::Request> request_ = std::make_shared<typename ServiceT::Request>();
  std::shared_future<typename ServiceT::Response::SharedPtr> future_result_;
  bool request_sent_ = false;
  bool should_send_request_ = true;
  rclcpp::Time sent_time_;
};
}  // namespace nav2_behavior_tree
