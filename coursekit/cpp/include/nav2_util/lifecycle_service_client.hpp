// The state of another node, asked and changed.
#pragma once
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "lifecycle_msgs/srv/change_state.hpp"
#include "lifecycle_msgs/srv/get_state.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/service_client.hpp"

namespace nav2_util
{
class LifecycleServiceClient
{
public:
  explicit LifecycleServiceClient(const std::string & lifecycle_node_name)
  : LifecycleServiceClient(lifecycle_node_name, generate_internal_node(lifecycle_node_name + "_lifecycle_client")) {}
  LifecycleServiceClient(const std::string & lifecycle_node_name, rclcpp::Node::SharedPtr parent_node)
  : node_(std::move(parent_node)), change_state_(lifecycle_node_name + "/change_state", node_),
    get_state_(lifecycle_node_name + "/get_state", node_) {}

  /// Whether the node answered; throws std::runtime_error where it does not within the timeout.
  bool change_state(const uint8_t transition, const std::chrono::seconds timeout)
  {
    return ask(transition, limit(timeout), limit(timeout)) != nullptr;
  }
  /// Whether the transition succeeded; waits for the answer for as long as it takes.
  bool change_state(std::uint8_t transition)
  {
    return ask(transition, std::chrono::seconds(5), std::chrono::nanoseconds(-1))->success;
  }
  uint8_t get_state(const std::chrono::seconds timeout = std::chrono::seconds::max())
  {
    if (!get_state_.wait_for_service(limit(timeout))) {
      throw std::runtime_error("get_state service is not available!");
    }
    auto request = std::make_shared<lifecycle_msgs::srv::GetState::Request>();
    return get_state_.invoke(request, limit(timeout))->current_state.id;
  }

protected:
  lifecycle_msgs::srv::ChangeState::Response::SharedPtr ask(
    uint8_t transition, std::chrono::nanoseconds until_there, std::chrono::nanoseconds until_answered)
  {
    if (!change_state_.wait_for_service(until_there)) {
      throw std::runtime_error("change_state service is not available!");
    }
    auto request = std::make_shared<lifecycle_msgs::srv::ChangeState::Request>();
    request->transition.id = transition;
    return change_state_.invoke(request, until_answered);
  }
  /// Nanoseconds cannot count the largest number of seconds, which stands for no limit.
  static std::chrono::nanoseconds limit(std::chrono::seconds timeout)
  {
    using std::chrono::nanoseconds;
    return timeout == std::chrono::seconds::max() ? nanoseconds(-1) : nanoseconds(timeout);
  }

  rclcpp::Node::SharedPtr node_;
  ServiceClient<lifecycle_msgs::srv::ChangeState> change_state_;
  ServiceClient<lifecycle_msgs::srv::GetState> get_state_;
};
}  // namespace nav2_util
