// Publishers of images: as they are, and in the form of each transport that somebody listens to.
#pragma once
#include "image_transport/loader_fwds.hpp"

namespace image_transport
{
class Publisher
{
public:
  using Image = sensor_msgs::msg::Image;
  Publisher() = default;
  Publisher(
    rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos,
    rclcpp::PublisherOptions options = rclcpp::PublisherOptions())
  : ends_(std::make_shared<Ends>())
  {
    ends_->raw = node->create_publisher<Image>(base_topic, detail::qos_of(qos), options);
    for (const std::string & name : detail::pub_loader().getDeclaredClasses()) {
      try {
        ends_->others.push_back(detail::pub_loader().createSharedInstance(name));
        ends_->others.back()->advertise(node, ends_->raw->get_topic_name(), qos, options);
      } catch (const std::runtime_error & error) {
        RCLCPP_ERROR(node->get_logger(), "Failed to load plugin %s, error string: %s\n", name.c_str(), error.what());
      }
    }
  }
  size_t getNumSubscribers() const
  {
    if (!ends_) {
      return 0;
    }
    size_t count = ends_->raw->get_subscription_count();
    for (auto & other : ends_->others) {
      count += other->getNumSubscribers();
    }
    return count;
  }
  std::string getTopic() const {return ends_ ? ends_->raw->get_topic_name() : "";}
  void publish(const Image & message) const
  {
    if (!ends_) {
      throw Exception("Call to publish() on an invalid image_transport::Publisher");
    }
    ends_->raw->publish(message);
    for (auto & other : ends_->others) {
      if (other->getNumSubscribers() > 0) {  // nobody waits for a form of it that takes time to make
        other->publish(message);
      }
    }
  }
  void publish(const Image::ConstSharedPtr & message) const {publish(*message);}
  void shutdown()
  {
    if (ends_) {
      for (auto & other : ends_->others) {
        other->shutdown();
      }
    }
    ends_.reset();
  }
  operator void *() const {return ends_.get();}
  bool operator==(const Publisher & o) const {return ends_ == o.ends_;}
  bool operator!=(const Publisher & o) const {return !(*this == o);}

private:
  struct Ends
  {
    rclcpp::Publisher<Image>::SharedPtr raw;
    std::vector<std::shared_ptr<PublisherPlugin>> others;
  };
  std::shared_ptr<Ends> ends_;
};
}  // namespace image_transport
