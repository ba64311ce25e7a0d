// Options of publishers and subscriptions.
#pragma once
#include <chrono>
#include <memory>

#include "rclcpp/callback_group.hpp"
#include "rclcpp/qos_event.hpp"

namespace rclcpp
{
enum class IntraProcessSetting {Enable, Disable, NodeDefault};
enum class TopicStatisticsState {Enable, Disable, NodeDefault};

struct PublisherOptionsBase
{
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  PublisherEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints{};
  std::shared_ptr<CallbackGroup> callback_group;
  QosOverridingOptions qos_overriding_options;
};
template<class Allocator = std::allocator<void>>
struct PublisherOptionsWithAllocator : PublisherOptionsBase
{
  PublisherOptionsWithAllocator() = default;
  PublisherOptionsWithAllocator(const PublisherOptionsBase & base)  // NOLINT
  : PublisherOptionsBase(base) {}
  std::shared_ptr<Allocator> get_allocator() const {return allocator ? allocator : std::make_shared<Allocator>();}
  std::shared_ptr<Allocator> allocator;
};
using PublisherOptions = PublisherOptionsWithAllocator<>;

struct ContentFilterOptions
{
  std::string filter_expression;
  std::vector<std::string> expression_parameters;
};
enum class IntraProcessBufferType {SharedPtr, UniquePtr, CallbackDefault};
struct SubscriptionOptionsBase
{
  SubscriptionEventCallbacks event_callbacks;
  bool use_default_callbacks = true;
  bool ignore_local_publications = false;
  rmw_unique_network_flow_endpoints_requirement_t require_unique_network_flow_endpoints{};
  std::shared_ptr<CallbackGroup> callback_group;
  IntraProcessSetting use_intra_process_comm = IntraProcessSetting::NodeDefault;
  /// As what messages that stay in the program are kept: here as the callback wants them.
  IntraProcessBufferType intra_process_buffer_type = IntraProcessBufferType::CallbackDefault;
  struct TopicStatisticsOptions
  {
    TopicStatisticsState state = TopicStatisticsState::NodeDefault;
    std::string publish_topic = "/statistics";
    std::chrono::milliseconds publish_period{1000};
  } topic_stats_options;
  QosOverridingOptions qos_overriding_options;
  ContentFilterOptions content_filter_options;
};
template<class Allocator = std::allocator<void>>
struct SubscriptionOptionsWithAllocator : SubscriptionOptionsBase
{
  SubscriptionOptionsWithAllocator() = default;
  SubscriptionOptionsWithAllocator(const SubscriptionOptionsBase & base)  // NOLINT
  : SubscriptionOptionsBase(base) {}
  std::shared_ptr<Allocator> get_allocator() const {return allocator ? allocator : std::make_shared<Allocator>();}
  std::shared_ptr<Allocator> allocator;
};
using SubscriptionOptions = SubscriptionOptionsWithAllocator<>;
}  // namespace rclcpp
