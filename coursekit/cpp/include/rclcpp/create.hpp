// The free functions that make entities of any kind of node.
#pragma once
#include "rclcpp/node.hpp"

namespace rclcpp
{
template<class T, class N>
typename Publisher<T>::SharedPtr create_publisher(
  N && node, const std::string & topic, const QoS & qos, const PublisherOptions & options = {})
{
  auto made = std::make_shared<Publisher<T>>();
  detail::make_publisher(*base_of(node), *made, MessageOf<T>::coursekit_type, topic, qos, options);
  return made;
}
template<class T, class N, class F>
typename Subscription<T>::SharedPtr create_subscription(
  N && node, const std::string & topic, const QoS & qos, F && callback, const SubscriptionOptions & options = {})
{
  auto made = std::make_shared<Subscription<T>>();
  made->call_back(std::forward<F>(callback));
  detail::make_subscription(*base_of(node), made, MessageOf<T>::coursekit_type, topic, qos, options);
  return made;
}
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
template<class Rep, class Period, class F, class N>
TimerBase::SharedPtr create_wall_timer(
  std::chrono::duration<Rep, Period> period, F callback, CallbackGroup::SharedPtr group, N && node, ...)
{
  auto nanoseconds = std::chrono::duration_cast<std::chrono::nanoseconds>(period);
  return detail::timer(*base_of(node), nanoseconds, std::move(callback), group, nullptr);
}
template<class S, class F>
typename Service<S>::SharedPtr create_service(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeServicesInterface::SharedPtr,
  const std::string & name, F && callback, const rmw_qos_profile_t & profile, CallbackGroup::SharedPtr group)
{
  return detail::service<S>(*base, name, std::forward<F>(callback), QoS(QoSInitialization::from_rmw(profile), profile), group);
}
template<class S>
typename Client<S>::SharedPtr create_client(
  node_interfaces::NodeBaseInterface::SharedPtr base, node_interfaces::NodeGraphInterface::SharedPtr,
  node_interfaces::NodeServicesInterface::SharedPtr, const std::string & name,
  const rmw_qos_profile_t & profile = rmw_qos_profile_services_default, CallbackGroup::SharedPtr group = nullptr)
{
  return detail::client<S>(*base, name, QoS(QoSInitialization::from_rmw(profile), profile), group);
}
}  // namespace rclcpp
