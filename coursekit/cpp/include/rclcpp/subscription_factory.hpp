// What makes a subscription for a node's interface of topics, which does not know its message's type.
#pragma once
#include "rclcpp/subscription.hpp"

namespace rclcpp
{
struct SubscriptionFactory
{
  using SubscriptionFactoryFunction = std::function<
    SubscriptionBase::SharedPtr(node_interfaces::NodeBaseInterface * node, const std::string & topic, const QoS & qos)>;
  const SubscriptionFactoryFunction create_typed_subscription;
};

template<class T, class F, class Alloc, class SubscriptionT = Subscription<T, Alloc>>
SubscriptionFactory create_subscription_factory(
  F && callback, const SubscriptionOptionsWithAllocator<Alloc> & options,
  typename SubscriptionT::MessageMemoryStrategyType::SharedPtr strategy, std::nullptr_t = nullptr)
{
  AnySubscriptionCallback<T, Alloc> any;
  any.set(std::decay_t<F>(std::forward<F>(callback)));
  auto make = [any, options, strategy](
    node_interfaces::NodeBaseInterface * node, const std::string & topic, const QoS & qos) -> SubscriptionBase::SharedPtr {
      return std::make_shared<SubscriptionT>(
        node, rclcpp::get_message_type_support_handle<T>(), topic, qos, any, options, strategy);
    };
  return {make};
}
}  // namespace rclcpp
