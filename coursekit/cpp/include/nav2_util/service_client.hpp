// A client that waits for its answers.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>

#include "rclcpp/rclcpp.hpp"

namespace nav2_util
{
template<class ServiceT>
class ServiceClient
{
public:
  using RequestType = typename ServiceT::Request;
  using ResponseType = typename ServiceT::Response;

  explicit ServiceClient(const std::string & service_name, const rclcpp::Node::SharedPtr & provided_node)
  : service_name_(service_name), node_(provided_node),
    group_(node_->create_callback_group(rclcpp::CallbackGroupType::MutuallyExclusive, false)),
    client_(node_->create_client<ServiceT>(service_name, rmw_qos_profile_services_default, group_))
  {
    executor_.add_callback_group(group_, node_->get_node_base_interface());
  }

  /// The answer; throws std::runtime_error where none comes. A negative timeout waits for as long as it takes.
  typename ResponseType::SharedPtr invoke(
    typename RequestType::SharedPtr & request, const std::chrono::nanoseconds timeout = std::chrono::nanoseconds(-1))
  {
    while (!client_->wait_for_service(std::chrono::seconds(1))) {
      if (!rclcpp::ok()) {
        throw std::runtime_error(service_name_ + " service client: interrupted while waiting for service");
      }
      RCLCPP_INFO(node_->get_logger(), "%s service client: waiting for service to appear...", service_name_.c_str());
    }
    RCLCPP_DEBUG(node_->get_logger(), "%s service client: send async request", service_name_.c_str());
    auto future = client_->async_send_request(request);
    if (executor_.spin_until_future_complete(future, timeout) != rclcpp::FutureReturnCode::SUCCESS) {
      client_->remove_pending_request(future);
      throw std::runtime_error(service_name_ + " service client: async_send_request failed");
    }
    return future.get();
  }
  bool invoke(typename RequestType::SharedPtr & request, typename ResponseType::SharedPtr & response)
  {
    response = invoke(request);
    return response != nullptr;
  }
  bool wait_for_service(const std::chrono::nanoseconds timeout = std::chrono::nanoseconds::max())
  {
    return client_->wait_for_service(timeout);
  }
  std::string getServiceName() {return service_name_;}

protected:
  std::string service_name_;
  rclcpp::Node::SharedPtr node_;
  rclcpp::CallbackGroup::SharedPtr group_;
  rclcpp::executors::SingleThreadedExecutor executor_;
  typename rclcpp::Client<ServiceT>::SharedPtr client_;
};
}  // namespace nav2_util
