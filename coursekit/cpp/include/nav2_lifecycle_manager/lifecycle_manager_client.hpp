// The services of a lifecycle_manager.
#pragma once
#include <chrono>
#include <memory>
#include <string>

#include "nav2_msgs/srv/manage_lifecycle_nodes.hpp"
#include "nav2_util/service_client.hpp"
#include "std_srvs/srv/trigger.hpp"

namespace nav2_lifecycle_manager
{
enum class SystemStatus {ACTIVE, INACTIVE, TIMEOUT};

class LifecycleManagerClient
{
public:
  /// `name` is that of the manager's node.
  explicit LifecycleManagerClient(const std::string & name, std::shared_ptr<rclcpp::Node> parent_node)
  : node_(std::move(parent_node)), manager_client_(name + "/manage_nodes", node_),
    is_active_client_(name + "/is_active", node_) {}

  /// Whether all nodes are active now; false also where no manager answers within the timeout.
  bool startup(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    return call(ManageLifecycleNodes::Request::STARTUP, timeout);
  }
  bool shutdown(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    return call(ManageLifecycleNodes::Request::SHUTDOWN, timeout);
  }
  bool pause(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    return call(ManageLifecycleNodes::Request::PAUSE, timeout);
  }
  bool resume(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    return call(ManageLifecycleNodes::Request::RESUME, timeout);
  }
  bool reset(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    return call(ManageLifecycleNodes::Request::RESET, timeout);
  }
  SystemStatus is_active(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    auto request = std::make_shared<std_srvs::srv::Trigger::Request>();
    try {
      if (!is_active_client_.wait_for_service(patience(timeout))) {
        return SystemStatus::TIMEOUT;
      }
      return is_active_client_.invoke(request, timeout)->success ? SystemStatus::ACTIVE : SystemStatus::INACTIVE;
    } catch (const std::runtime_error &) {
      return SystemStatus::TIMEOUT;
    }
  }

protected:
  using ManageLifecycleNodes = nav2_msgs::srv::ManageLifecycleNodes;

  bool call(uint8_t command, const std::chrono::nanoseconds timeout)
  {
    auto request = std::make_shared<ManageLifecycleNodes::Request>();
    request->command = command;
    try {
      return manager_client_.wait_for_service(patience(timeout)) && manager_client_.invoke(request, timeout)->success;
    } catch (const std::runtime_error &) {
      return false;
    }
  }
  static std::chrono::nanoseconds patience(std::chrono::nanoseconds timeout)
  {
    return timeout.count() < 0 ? std::chrono::nanoseconds::max() : timeout;
  }

  rclcpp::Node::SharedPtr node_;
  nav2_util::ServiceClient<ManageLifecycleNodes> manager_client_;
  nav2_util::ServiceClient<std_srvs::srv::Trigger> is_active_client_;
};
}  // namespace nav2_lifecycle_manager
