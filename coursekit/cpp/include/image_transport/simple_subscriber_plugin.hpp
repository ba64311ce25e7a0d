// The other end of a transport of images: see simple_publisher_plugin.hpp.
#pragma once
#include "image_transport/exception.hpp"

namespace image_transport
{
/// Hears images in some form, on a topic of its own below that of the images.
class SubscriberPlugin
{
public:
  using Image = sensor_msgs::msg::Image;
  using Callback = std::function<void (const Image::ConstSharedPtr &)>;
  SubscriberPlugin() = default;
  SubscriberPlugin(const SubscriberPlugin &) = delete;
  SubscriberPlugin & operator=(const SubscriberPlugin &) = delete;
  virtual ~SubscriberPlugin() = default;
  virtual std::string getTransportName() const = 0;
  void subscribe(
    rclcpp::Node * node, const std::string & base_topic, const Callback & callback,
    rmw_qos_profile_t qos = rmw_qos_profile_default, rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
  {
    subscribeImpl(node, base_topic, callback, qos, options);
  }
  virtual std::string getTopic() const = 0;
  virtual size_t getNumPublishers() const = 0;
  virtual void shutdown() = 0;
  static std::string getLookupName(const std::string & transport_name) {return "image_transport/" + transport_name + "_sub";}

protected:
  virtual void subscribeImpl(
    rclcpp::Node * node, const std::string & base_topic, const Callback & callback, rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) = 0;
};

/// Hears messages of type M, of each of which `internalCallback` makes an image.
template<class M>
class SimpleSubscriberPlugin : public SubscriberPlugin
{
public:
  std::string getTopic() const override {return subscription_ ? subscription_->get_topic_name() : "";}
  size_t getNumPublishers() const override {return subscription_ ? subscription_->get_publisher_count() : 0;}
  void shutdown() override {subscription_.reset();}

protected:
  virtual void internalCallback(const std::shared_ptr<const M> & message, const Callback & user_cb) = 0;
  virtual std::string getTopicToSubscribe(const std::string & base_topic) const {return base_topic + "/" + getTransportName();}
  void subscribeImpl(
    rclcpp::Node * node, const std::string & base_topic, const Callback & callback, rmw_qos_profile_t qos,
    rclcpp::SubscriptionOptions options) override
  {
    auto heard = [this, callback](std::shared_ptr<const M> message) {internalCallback(message, callback);};
    subscription_ = node->create_subscription<M>(getTopicToSubscribe(base_topic), detail::qos_of(qos), heard, options);
  }

private:
  typename rclcpp::Subscription<M>::SharedPtr subscription_;
};
}  // namespace image_transport
