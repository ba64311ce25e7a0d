// What makes a publisher for a node's interface of topics, which does not know its message's type.
#pragma once
#include "rclcpp/publisher.hpp"

namespace rclcpp
{
struct PublisherFactory
{
  using PublisherFactoryFunction = std::function<
    PublisherBase::SharedPtr(node_interfaces::NodeBaseInterface * node, const std::string & topic, const QoS & qos)>;
  const PublisherFactoryFunction create_typed_publisher;
};

template<class T, class Alloc, class PublisherT = Publisher<T, Alloc>>
PublisherFactory create_publisher_factory(const PublisherOptionsWithAllocator<Alloc> & options)
{
  auto make = [options](
    node_interfaces::NodeBaseInterface * node, const std::string & topic, const QoS & qos) -> PublisherBase::SharedPtr {
      return std::make_shared<PublisherT>(node, topic, qos, options);
    };
  return {make};
}
}  // namespace rclcpp
