// Publishers of images: as they are, and in the form of each transport that somebody listens to.
#pragma once
#include <algorithm>

#include "image_transport/loader_fwds.hpp"
#include "rclcpp/expand_topic_or_service_name.hpp"

namespace image_transport
{
namespace detail
{
/// The parameter that names a topic's transports: the topic below the node's namespace, with dots.
inline std::string transports_parameter(const rclcpp::Node & node, const std::string & topic)
{
  const std::string space = node.get_effective_namespace();
  std::string name = topic.rfind(space, 0) == 0 ? topic.substr(space.size()) : topic;
  std::replace(name.begin(), name.end(), '/', '.');
  return (name.rfind('.', 0) == 0 ? name.substr(1) : name) + ".enable_pub_plugins";
}
/// The transports that a topic has: by default "raw", and all that packages describe.
inline std::vector<std::string> transports_of(rclcpp::Node & node, const std::string & base_topic)
{
  std::vector<std::string> all = {"image_transport/raw"};
  for (const std::string & name : pub_loader().getDeclaredClasses()) {
    all.push_back(transport_named(name));
  }
  const std::string topic = rclcpp::expand_topic_or_service_name(base_topic, node.get_name(), node.get_namespace());
  const std::string parameter = transports_parameter(node, topic);
  return node.has_parameter(parameter) ? node.get_parameter(parameter).as_string_array() : node.declare_parameter(parameter, all);
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
  : ends_(std::make_shared<Ends>())
  {
    const std::vector<std::string> wanted = detail::transports_of(*node, base_topic);
    auto is_wanted = [&](const std::string & name) {return std::find(wanted.begin(), wanted.end(), name) != wanted.end();};
    auto raw = node->create_publisher<Image>(base_topic, detail::qos_of(qos), options);
    ends_->topic = raw->get_topic_name();
    ends_->raw = is_wanted("image_transport/raw") ? raw : nullptr;
    for (const std::string & name : detail::pub_loader().getDeclaredClasses()) {
      if (is_wanted(detail::transport_named(name))) {
        add(node, name, qos, options);
      }
    }
    if (!ends_->raw && ends_->others.empty()) {
      throw Exception("No plugins found! Does `rospack plugins --attrib=plugin image_transport` find any packages?");
    }
  }
  size_t getNumSubscribers() const
  {
    if (!ends_) {
      return 0;
    }
    size_t count = ends_->raw ? ends_->raw->get_subscription_count() : 0;
    for (auto & other : ends_->others) {
      count += other->getNumSubscribers();
    }
    return count;
  }
  std::string getTopic() const {return ends_ ? ends_->topic : "";}
  void publish(const Image & message) const
  {
    if (!ends_) {
      throw Exception("Call to publish() on an invalid image_transport::Publisher");
    }
    if (ends_->raw) {
      ends_->raw->publish(message);
    }
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
  void add(rclcpp::Node * node, const std::string & name, rmw_qos_profile_t qos, const rclcpp::PublisherOptions & options)
  {
    try {
      ends_->others.push_back(detail::pub_loader().createSharedInstance(name));
      ends_->others.back()->advertise(node, ends_->topic, qos, options);
    } catch (const std::runtime_error & error) {
      RCLCPP_ERROR(node->get_logger(), "Failed to load plugin %s, error string: %s\n", name.c_str(), error.what());
    }
  }
  struct Ends
  {
    std::string topic;
    rclcpp::Publisher<Image>::SharedPtr raw;
    std::vector<std::shared_ptr<PublisherPlugin>> others;
  };
  std::shared_ptr<Ends> ends_;
};
}  // namespace image_transport
