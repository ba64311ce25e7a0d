// A subscription of images as a filter.
#pragma once
#include "image_transport/image_transport.hpp"
#include "message_filters/simple_filter.h"

namespace image_transport
{
class SubscriberFilter : public message_filters::SimpleFilter<sensor_msgs::msg::Image>
{
public:
  SubscriberFilter() = default;
  SubscriberFilter(
    rclcpp::Node * node, const std::string & base_topic, const std::string & transport,
    rmw_qos_profile_t qos = rmw_qos_profile_default)
  {
    subscribe(node, base_topic, transport, qos);
  }
  ~SubscriberFilter() override {unsubscribe();}
  void subscribe(
    rclcpp::Node * node, const std::string & base_topic, const std::string & transport,
    rmw_qos_profile_t qos = rmw_qos_profile_default, rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
  {
    unsubscribe();
    auto heard = [this](const sensor_msgs::msg::Image::ConstSharedPtr & image) {signalMessage(image);};
    subscriber_ = create_subscription(node, base_topic, heard, transport, qos, options);
  }
  void unsubscribe() {subscriber_.shutdown();}
  std::string getTopic() const {return subscriber_.getTopic();}
  size_t getNumPublishers() const {return subscriber_.getNumPublishers();}
  std::string getTransport() const {return subscriber_.getTransport();}
  const Subscriber & getSubscriber() const {return subscriber_;}

private:
  Subscriber subscriber_;
};
}  // namespace image_transport
