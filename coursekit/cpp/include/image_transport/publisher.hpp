// Publishers and subscribers of images.
#pragma once
#include "rclcpp/rclcpp.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace image_transport
{
class Exception : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
class TransportLoadException : public Exception
{
public:
  TransportLoadException(const std::string & transport, const std::string & text)
  : Exception("Unable to load plugin for transport '" + transport + "', error string:\n" + text), transport_(transport) {}
  std::string getTransport() const {return transport_;}

private:
  std::string transport_;
};

/// The transport that a subscriber wants: its node's parameter, "raw" without it.
class TransportHints
{
public:
  explicit TransportHints(
    const rclcpp::Node * node, const std::string & default_transport = "raw",
    const std::string & parameter_name = "image_transport")
  : transport_(node->get_parameter_or<std::string>(parameter_name, default_transport)) {}
  const std::string & getTransport() const {return transport_;}

private:
  std::string transport_;
};

namespace detail
{
inline rclcpp::QoS qos_of(const rmw_qos_profile_t & profile)
{
  return rclcpp::QoS(rclcpp::QoSInitialization::from_rmw(profile), profile);
}
}  // namespace detail

class Publisher
{
public:
  using Image = sensor_msgs::msg::Image;
  Publisher() = default;
  Publisher(
    rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos,
    rclcpp::PublisherOptions options = rclcpp::PublisherOptions())
  : publisher_(node->create_publisher<Image>(base_topic, detail::qos_of(qos), options)) {}
  size_t getNumSubscribers() const {return publisher_ ? publisher_->get_subscription_count() : 0;}
  std::string getTopic() const {return publisher_ ? publisher_->get_topic_name() : "";}
  void publish(const Image & message) const {valid().publish(message);}
  void publish(const Image::ConstSharedPtr & message) const {valid().publish(*message);}
  void shutdown() {publisher_.reset();}
  operator void *() const {return publisher_.get();}
  bool operator==(const Publisher & o) const {return publisher_ == o.publisher_;}
  bool operator!=(const Publisher & o) const {return !(*this == o);}

private:
  rclcpp::Publisher<Image> & valid() const
  {
    if (!publisher_) {
      throw Exception("Call to publish() on an invalid image_transport::Publisher");
    }
    return *publisher_;
  }
  rclcpp::Publisher<Image>::SharedPtr publisher_;
};

class Subscriber
{
public:
  using Image = sensor_msgs::msg::Image;
  using Callback = std::function<void (const Image::ConstSharedPtr &)>;
  Subscriber() = default;
  Subscriber(
    rclcpp::Node * node, const std::string & base_topic, const Callback & callback, const std::string & transport,
    rmw_qos_profile_t qos = rmw_qos_profile_default, rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
  : transport_(transport)
  {
    if (transport != "raw") {
      throw TransportLoadException(transport, "here C++ has the transport raw; rqt_image_view and Python read compressed images");
    }
    auto heard = [callback](Image::ConstSharedPtr image) {callback(image);};
    subscription_ = node->create_subscription<Image>(base_topic, detail::qos_of(qos), heard, options);
  }
  std::string getTopic() const {return subscription_ ? subscription_->get_topic_name() : "";}
  size_t getNumPublishers() const {return subscription_ ? subscription_->get_publisher_count() : 0;}
  std::string getTransport() const {return transport_;}
  void shutdown() {subscription_.reset();}
  operator void *() const {return subscription_.get();}
  bool operator==(const Subscriber & o) const {return subscription_ == o.subscription_;}
  bool operator!=(const Subscriber & o) const {return !(*this == o);}

private:
  rclcpp::Subscription<Image>::SharedPtr subscription_;
  std::string transport_;
};
}  // namespace image_transport
