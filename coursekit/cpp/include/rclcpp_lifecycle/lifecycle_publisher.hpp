// A publisher that is silent while its node is not active. Through a pointer to an rclcpp::Publisher it always speaks.
#pragma once
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/managed_entity.hpp"

namespace rclcpp_lifecycle
{
using LifecyclePublisherInterface = ManagedEntityInterface;

template<class T, class Alloc = std::allocator<void>>
class LifecyclePublisher : public SimpleManagedEntity, public rclcpp::Publisher<T, Alloc>
{
  using Base = rclcpp::Publisher<T, Alloc>;

public:
  RCLCPP_SMART_PTR_DEFINITIONS(LifecyclePublisher)
  using typename Base::PublishedType;
  LifecyclePublisher() = default;
  /// One that publishes as soon as a node takes it in, with NodeTopicsInterface::add_publisher().
  LifecyclePublisher(
    rclcpp::node_interfaces::NodeBaseInterface * node_base, const std::string & topic, const rclcpp::QoS & qos,
    const rclcpp::PublisherOptionsWithAllocator<Alloc> & options)
  : Base(node_base, topic, qos, options) {}

  template<class Deleter>
  void publish(std::unique_ptr<PublishedType, Deleter> message)
  {
    if (may_speak()) {
      Base::publish(std::move(message));
    }
  }
  void publish(const PublishedType & message)
  {
    if (may_speak()) {
      Base::publish(message);
    }
  }
  void publish(rclcpp::LoanedMessage<PublishedType> && message)
  {
    if (may_speak()) {
      Base::publish(std::move(message));
    }
  }
  void on_activate() override
  {
    SimpleManagedEntity::on_activate();
    warned_ = false;
  }

private:
  bool may_speak()
  {
    if (!is_activated() && !warned_.exchange(true)) {
      RCLCPP_WARN(
        rclcpp::get_logger("LifecyclePublisher"),
        "Trying to publish message on the topic '%s', but the publisher is not activated", this->get_topic_name());
    }
    return is_activated();
  }
  std::atomic<bool> warned_{false};
};
}  // namespace rclcpp_lifecycle
