// Subscribers of images: as they are, or in the form of a transport.
#pragma once
#include "image_transport/loader_fwds.hpp"

namespace image_transport
{
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
    if (transport == "raw") {
      auto heard = [callback](Image::ConstSharedPtr image) {callback(image);};
      subscription_ = node->create_subscription<Image>(base_topic, detail::qos_of(qos), heard, options);
    } else {
      plugin_ = loaded(transport);
      plugin_->subscribe(node, base_topic, callback, qos, options);
    }
  }
  std::string getTopic() const
  {
    return plugin_ ? plugin_->getTopic() : subscription_ ? subscription_->get_topic_name() : "";
  }
  size_t getNumPublishers() const
  {
    return plugin_ ? plugin_->getNumPublishers() : subscription_ ? subscription_->get_publisher_count() : 0;
  }
  std::string getTransport() const {return transport_;}
  void shutdown()
  {
    if (plugin_) {
      plugin_->shutdown();
    }
    plugin_.reset();
    subscription_.reset();
  }
  operator void *() const {return plugin_ ? static_cast<void *>(plugin_.get()) : subscription_.get();}
  bool operator==(const Subscriber & o) const {return plugin_ == o.plugin_ && subscription_ == o.subscription_;}
  bool operator!=(const Subscriber & o) const {return !(*this == o);}

private:
  static std::shared_ptr<SubscriberPlugin> loaded(const std::string & transport)
  {
    try {
      return detail::sub_loader().createSharedInstance(SubscriberPlugin::getLookupName(transport));
    } catch (const pluginlib::PluginlibException & error) {
      throw TransportLoadException(
              transport, std::string(error.what()) + "\nHere C++ has the transport raw, and those of packages in the "
              "workspace; rqt_image_view and Python read compressed images");
    }
  }
  rclcpp::Subscription<Image>::SharedPtr subscription_;
  std::shared_ptr<SubscriberPlugin> plugin_;
  std::string transport_;
};
}  // namespace image_transport
