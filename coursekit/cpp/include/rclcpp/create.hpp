// The free functions that make entities: of any kind of node, or of the interfaces of one.
#pragma once
#include "rclcpp/node.hpp"

namespace rclcpp
{
// -- topics

template<class T, class Alloc = std::allocator<void>, class PublisherT = Publisher<T, Alloc>, class N>
std::shared_ptr<PublisherT> create_publisher(
  N && node, const std::string & topic, const QoS & qos,
  const PublisherOptionsWithAllocator<Alloc> & options = PublisherOptionsWithAllocator<Alloc>())
{
  return detail::publisher<PublisherT>(*base_of(node), MessageOf<T>::coursekit_type, topic, qos, options);
}
/// The same of the interfaces for parameters and topics.
template<class T, class Alloc = std::allocator<void>, class PublisherT = Publisher<T, Alloc>>
std::shared_ptr<PublisherT> create_publisher(
  node_interfaces::NodeParametersInterface::SharedPtr, node_interfaces::NodeTopicsInterface::SharedPtr topics,
  const std::string & topic, const QoS & qos,
  const PublisherOptionsWithAllocator<Alloc> & options = PublisherOptionsWithAllocator<Alloc>())
{
  return create_publisher<T, Alloc, PublisherT>(topics, topic, qos, options);
}
template<class Alloc = std::allocator<void>>
GenericPublisher::SharedPtr create_generic_publisher(
  node_interfaces::NodeTopicsInterface::SharedPtr topics, const std::string & topic, const std::string & type, const QoS & qos,
  const PublisherOptionsWithAllocator<Alloc> & options = PublisherOptionsWithAllocator<Alloc>())
{
  auto made = std::make_shared<GenericPublisher>();
  detail::make_publisher(*topics, *made, type, topic, qos, options);
  return made;
}
template<class T, class F, class Alloc = std::allocator<void>, class N, class ... Strategy>
typename Subscription<T, Alloc>::SharedPtr create_subscription(
  N && node, const std::string & topic, const QoS & qos, F && callback,
  const SubscriptionOptionsWithAllocator<Alloc> & options = SubscriptionOptionsWithAllocator<Alloc>(), const Strategy & ... strategy)
{
  auto made = std::make_shared<Subscription<T, Alloc>>();
  made->take_messages_from(strategy ...);
  made->call_back(std::forward<F>(callback));
  detail::make_subscription(*base_of(node), made, MessageOf<T>::coursekit_type, topic, qos, options);
  return made;
}
/// The same of the interfaces for parameters and topics.
template<class T, class F, class Alloc = std::allocator<void>, class ... Strategy>
typename Subscription<T, Alloc>::SharedPtr create_subscription(
  node_interfaces::NodeParametersInterface::SharedPtr, node_interfaces::NodeTopicsInterface::SharedPtr topics,
  const std::string & topic, const QoS & qos, F && callback,
  const SubscriptionOptionsWithAllocator<Alloc> & options = SubscriptionOptionsWithAllocator<Alloc>(), const Strategy & ... strategy)
{
  return create_subscription<T>(topics, topic, qos, std::forward<F>(callback), options, strategy ...);
}
template<class F, class Alloc = std::allocator<void>>
GenericSubscription::SharedPtr create_generic_subscription(
  node_interfaces::NodeTopicsInterface::SharedPtr topics, const std::string & topic, const std::string & type, const QoS & qos,
  F && callback, const SubscriptionOptionsWithAllocator<Alloc> & options = SubscriptionOptionsWithAllocator<Alloc>())
{
  auto made = std::make_shared<GenericSubscription>(type);
  made->call_back(std::forward<F>(callback));
  detail::make_subscription(*topics, made, type, topic, qos, options);
  return made;
}

// -- timers

template<class N, class F>
TimerBase::SharedPtr create_timer(
  N && node, Clock::SharedPtr clock, Duration period, F && callback, CallbackGroup::SharedPtr group = nullptr)
{
  auto nanoseconds = std::chrono::nanoseconds(period.nanoseconds());
  return detail::timer(*base_of(node), nanoseconds, std::decay_t<F>(std::forward<F>(callback)), group, clock);
}
template<class F>
TimerBase::SharedPtr create_timer(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeTimersInterface::SharedPtr,
  Clock::SharedPtr clock, Duration period, F && callback, CallbackGroup::SharedPtr group = nullptr)
{
  return create_timer(base, clock, period, std::forward<F>(callback), group);
}
template<class Rep, class Period, class F>
TimerBase::SharedPtr create_wall_timer(
  std::chrono::duration<Rep, Period> period, F callback, CallbackGroup::SharedPtr group,
  node_interfaces::NodeBaseInterface * node, node_interfaces::NodeTimersInterface * timers)
{
  if (!node || !timers) {
    throw std::invalid_argument(node ? "input node_timers cannot be null" : "input node_base cannot be null");
  }
  return detail::timer(*node, detail::timer_period(period), std::move(callback), group, nullptr);
}

// -- services

template<class S, class F>
typename Service<S>::SharedPtr create_service(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeServicesInterface::SharedPtr,
  const std::string & name, F && callback, const QoS & qos, CallbackGroup::SharedPtr group)
{
  return detail::service<S>(*base, name, std::forward<F>(callback), qos, group);
}
template<class S, class F>
typename Service<S>::SharedPtr create_service(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeServicesInterface::SharedPtr services,
  const std::string & name, F && callback, const rmw_qos_profile_t & profile, CallbackGroup::SharedPtr group)
{
  const QoS qos(QoSInitialization::from_rmw(profile), profile);
  return create_service<S>(base, services, name, std::forward<F>(callback), qos, group);
}
template<class S>
typename Client<S>::SharedPtr create_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeGraphInterface::SharedPtr,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & name, const QoS & qos = ServicesQoS(),
  CallbackGroup::SharedPtr group = nullptr)
{
  return detail::client<S>(*base, name, qos, group);
}
template<class S>
typename Client<S>::SharedPtr create_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeGraphInterface::SharedPtr graph,
  node_interfaces::NodeServicesInterface::SharedPtr services, const std::string & name, const rmw_qos_profile_t & profile,
  CallbackGroup::SharedPtr group = nullptr)
{
  return create_client<S>(base, graph, services, name, QoS(QoSInitialization::from_rmw(profile), profile), group);
}
}  // namespace rclcpp
