// What a package makes a transport of images from: its description names this class, and programs load it by that.
#pragma once
#include "image_transport/exception.hpp"

namespace image_transport
{
/// Sends images in some form, on a topic of its own below that of the images.
class PublisherPlugin
{
public:
  using Image = sensor_msgs::msg::Image;
  PublisherPlugin() = default;
  PublisherPlugin(const PublisherPlugin &) = delete;
  PublisherPlugin & operator=(const PublisherPlugin &) = delete;
  virtual ~PublisherPlugin() = default;
  virtual std::string getTransportName() const = 0;
  void advertise(
    rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos = rmw_qos_profile_default,
    rclcpp::PublisherOptions options = rclcpp::PublisherOptions())
  {
    advertiseImpl(node, base_topic, qos, options);
  }
  virtual size_t getNumSubscribers() const = 0;
  virtual std::string getTopic() const = 0;
  virtual void publish(const Image & message) const = 0;
  virtual void publishPtr(const Image::ConstSharedPtr & message) const {publish(*message);}
  virtual void shutdown() = 0;
  static std::string getLookupName(const std::string & transport_name) {return "image_transport/" + transport_name + "_pub";}

protected:
  virtual void advertiseImpl(
    rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos, rclcpp::PublisherOptions options) = 0;
};

/// Sends each image as one message of type M, which `publish` makes.
template<class M>
class SimplePublisherPlugin : public PublisherPlugin
{
public:
  size_t getNumSubscribers() const override {return publisher_ ? publisher_->get_subscription_count() : 0;}
  std::string getTopic() const override {return publisher_ ? publisher_->get_topic_name() : "";}
  void publish(const Image & message) const override
  {
    if (publisher_) {
      publish(message, [this](const M & made) {publisher_->publish(made);});
    }
  }
  void shutdown() override {publisher_.reset();}

protected:
  using PublisherT = typename rclcpp::Publisher<M>::SharedPtr;
  using PublishFn = std::function<void (const M &)>;
  virtual void publish(const Image & message, const PublishFn & publish_fn) const = 0;
  virtual std::string getTopicToAdvertise(const std::string & base_topic) const {return base_topic + "/" + getTransportName();}
  void advertiseImpl(
    rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos, rclcpp::PublisherOptions options) override
  {
    publisher_ = node->create_publisher<M>(getTopicToAdvertise(base_topic), detail::qos_of(qos), options);
  }
  const PublisherT & getPublisher() const {return publisher_;}

private:
  PublisherT publisher_;
};
}  // namespace image_transport
