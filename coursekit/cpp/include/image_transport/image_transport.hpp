// Images on topics, as they are ("raw") or in other forms, with or without the camera's calibration beside them.
#pragma once
#include "image_transport/camera.hpp"

namespace image_transport
{
inline Publisher create_publisher(
  rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos = rmw_qos_profile_default,
  rclcpp::PublisherOptions options = rclcpp::PublisherOptions())
{
  return Publisher(node, base_topic, qos, options);
}
inline Subscriber create_subscription(
  rclcpp::Node * node, const std::string & base_topic, const Subscriber::Callback & callback, const std::string & transport,
  rmw_qos_profile_t qos = rmw_qos_profile_default, rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
{
  return Subscriber(node, base_topic, callback, transport, qos, options);
}
inline CameraPublisher create_camera_publisher(
  rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos = rmw_qos_profile_default)
{
  return CameraPublisher(node, base_topic, qos);
}
inline CameraSubscriber create_camera_subscription(
  rclcpp::Node * node, const std::string & base_topic, const CameraSubscriber::Callback & callback,
  const std::string & transport, rmw_qos_profile_t qos = rmw_qos_profile_default)
{
  return CameraSubscriber(node, base_topic, callback, transport, qos);
}

class ImageTransport
{
public:
  using ImageConstPtr = sensor_msgs::msg::Image::ConstSharedPtr;
  using CameraInfoConstPtr = sensor_msgs::msg::CameraInfo::ConstSharedPtr;
  using VoidPtr = std::shared_ptr<void>;
  explicit ImageTransport(rclcpp::Node::SharedPtr node)
  : node_(std::move(node)) {}

  Publisher advertise(const std::string & base_topic, uint32_t queue_size, bool latch = false)
  {
    return advertise(base_topic, profile(queue_size, latch));
  }
  Publisher advertise(const std::string & base_topic, rmw_qos_profile_t qos, bool = false)
  {
    return create_publisher(node_.get(), base_topic, qos);
  }
  CameraPublisher advertiseCamera(const std::string & base_topic, uint32_t queue_size, bool latch = false)
  {
    return create_camera_publisher(node_.get(), base_topic, profile(queue_size, latch));
  }
  Subscriber subscribe(
    const std::string & base_topic, uint32_t queue_size, const Subscriber::Callback & callback,
    const VoidPtr & tracked = VoidPtr(), const TransportHints * hints = nullptr,
    rclcpp::SubscriptionOptions options = rclcpp::SubscriptionOptions())
  {
    auto kept = [callback, tracked](const ImageConstPtr & image) {callback(image);};
    return create_subscription(node_.get(), base_topic, kept, transport_of(hints), profile(queue_size), options);
  }
  template<class R>
  Subscriber subscribe(
    const std::string & base_topic, uint32_t queue_size, R (* callback)(const ImageConstPtr &),
    const TransportHints * hints = nullptr)
  {
    return subscribe(base_topic, queue_size, Subscriber::Callback(callback), VoidPtr(), hints);
  }
  template<class T>
  Subscriber subscribe(
    const std::string & base_topic, uint32_t queue_size, void (T::* callback)(const ImageConstPtr &), T * object,
    const TransportHints * hints = nullptr)
  {
    auto called = [callback, object](const ImageConstPtr & image) {(object->*callback)(image);};
    return subscribe(base_topic, queue_size, Subscriber::Callback(called), VoidPtr(), hints);
  }
  template<class T>
  Subscriber subscribe(
    const std::string & base_topic, uint32_t queue_size, void (T::* callback)(const ImageConstPtr &),
    const std::shared_ptr<T> & object, const TransportHints * hints = nullptr)
  {
    return subscribe(base_topic, queue_size, callback, object.get(), hints);
  }
  CameraSubscriber subscribeCamera(
    const std::string & base_topic, uint32_t queue_size, const CameraSubscriber::Callback & callback,
    const VoidPtr & = VoidPtr(), const TransportHints * hints = nullptr)
  {
    return create_camera_subscription(node_.get(), base_topic, callback, transport_of(hints), profile(queue_size));
  }
  template<class T>
  CameraSubscriber subscribeCamera(
    const std::string & base_topic, uint32_t queue_size,
    void (T::* callback)(const ImageConstPtr &, const CameraInfoConstPtr &), T * object,
    const TransportHints * hints = nullptr)
  {
    using std::placeholders::_1;
    using std::placeholders::_2;
    return subscribeCamera(base_topic, queue_size, std::bind(callback, object, _1, _2), VoidPtr(), hints);
  }
  /// "raw", and what packages of the workspace describe; of these, what has a library.
  std::vector<std::string> getDeclaredTransports() const
  {
    return transports([](const std::string &) {return true;});
  }
  std::vector<std::string> getLoadableTransports() const
  {
    return transports(
      [](const std::string & name) {
        try {
          return detail::sub_loader().createSharedInstance(name) != nullptr;
        } catch (const pluginlib::PluginlibException &) {
          return false;
        }
      });
  }

private:
  template<class Wanted>
  static std::vector<std::string> transports(Wanted wanted)
  {
    std::vector<std::string> names = {"image_transport/raw"};
    for (const std::string & name : detail::sub_loader().getDeclaredClasses()) {
      if (wanted(name)) {
        names.push_back(detail::transport_named(name));
      }
    }
    return names;
  }
  static rmw_qos_profile_t profile(uint32_t queue_size, bool latch = false)
  {
    rmw_qos_profile_t qos = rmw_qos_profile_default;
    qos.depth = queue_size;
    qos.durability = latch ? RMW_QOS_POLICY_DURABILITY_TRANSIENT_LOCAL : qos.durability;
    return qos;
  }
  /// The transport that a node's parameter asks for, or the caller.
  std::string transport_of(const TransportHints * hints)
  {
    return hints ? hints->getTransport() : TransportHints(node_.get()).getTransport();
  }
  rclcpp::Node::SharedPtr node_;
};
}  // namespace image_transport
