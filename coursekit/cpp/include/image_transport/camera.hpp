// Images with the calibration of their camera, which has the same stamp.
#pragma once
#include "image_transport/publisher.hpp"
#include "image_transport/subscriber.hpp"
#include "sensor_msgs/msg/camera_info.hpp"

namespace image_transport
{
/// The topic of the calibration: camera_info beside the image's.
inline std::string getCameraInfoTopic(const std::string & base_topic)
{
  size_t slash = base_topic.rfind('/');
  return slash == std::string::npos ? "camera_info" : base_topic.substr(0, slash + 1) + "camera_info";
}

class CameraPublisher
{
public:
  using Image = sensor_msgs::msg::Image;
  using Info = sensor_msgs::msg::CameraInfo;
  CameraPublisher() = default;
  CameraPublisher(rclcpp::Node * node, const std::string & base_topic, rmw_qos_profile_t qos = rmw_qos_profile_default)
  : image_(node, base_topic, qos),
    info_(node->create_publisher<Info>(getCameraInfoTopic(image_.getTopic()), detail::qos_of(qos))) {}
  size_t getNumSubscribers() const
  {
    return info_ ? std::max(image_.getNumSubscribers(), info_->get_subscription_count()) : 0;
  }
  std::string getTopic() const {return image_.getTopic();}
  std::string getInfoTopic() const {return info_ ? info_->get_topic_name() : "";}
  void publish(const Image & image, const Info & info) const
  {
    if (!info_) {
      throw Exception("Call to publish() on an invalid image_transport::CameraPublisher");
    }
    image_.publish(image);
    info_->publish(info);
  }
  void publish(const Image::ConstSharedPtr & image, const Info::ConstSharedPtr & info) const {publish(*image, *info);}
  /// Publish both with one stamp.
  void publish(Image & image, Info & info, rclcpp::Time stamp) const
  {
    image.header.stamp = info.header.stamp = stamp;
    publish(image, info);
  }
  void shutdown()
  {
    image_.shutdown();
    info_.reset();
  }
  operator void *() const {return info_.get();}

private:
  Publisher image_;
  rclcpp::Publisher<Info>::SharedPtr info_;
};

class CameraSubscriber
{
public:
  using Image = sensor_msgs::msg::Image;
  using Info = sensor_msgs::msg::CameraInfo;
  using Callback = std::function<void (const Image::ConstSharedPtr &, const Info::ConstSharedPtr &)>;
  CameraSubscriber() = default;
  CameraSubscriber(
    rclcpp::Node * node, const std::string & base_topic, const Callback & callback, const std::string & transport,
    rmw_qos_profile_t qos = rmw_qos_profile_default)
  : pairs_(std::make_shared<Pairs>())
  {
    auto pairs = pairs_;
    pairs->callback = callback;
    image_ = Subscriber(
      node, base_topic, [pairs](const Image::ConstSharedPtr & image) {pairs->take(pairs->images, image);}, transport, qos);
    info_ = node->create_subscription<Info>(
      getCameraInfoTopic(image_.getTopic()), detail::qos_of(qos),
      [pairs](Info::ConstSharedPtr info) {pairs->take(pairs->infos, info);});
  }
  std::string getTopic() const {return image_.getTopic();}
  std::string getInfoTopic() const {return info_ ? info_->get_topic_name() : "";}
  size_t getNumPublishers() const
  {
    return info_ ? std::max(image_.getNumPublishers(), info_->get_publisher_count()) : 0;
  }
  std::string getTransport() const {return image_.getTransport();}
  void shutdown()
  {
    image_.shutdown();
    info_.reset();
  }
  operator void *() const {return info_.get();}

private:
  /// What waits for its other half, by its stamp.
  struct Pairs
  {
    static constexpr size_t KEPT = 10;
    Callback callback;
    std::mutex lock;
    std::map<int64_t, Image::ConstSharedPtr> images;
    std::map<int64_t, Info::ConstSharedPtr> infos;
    template<class M>
    void take(std::map<int64_t, M> & waiting, const M & message)
    {
      int64_t stamp = rclcpp::Time(message->header.stamp).nanoseconds();
      Image::ConstSharedPtr image;
      Info::ConstSharedPtr info;
      {
        std::lock_guard<std::mutex> hold(lock);
        waiting[stamp] = message;
        if (waiting.size() > KEPT) {
          waiting.erase(waiting.begin());
        }
        if (!images.count(stamp) || !infos.count(stamp)) {
          return;
        }
        image = images[stamp];
        info = infos[stamp];
        images.erase(images.begin(), images.upper_bound(stamp));
        infos.erase(infos.begin(), infos.upper_bound(stamp));
      }
      callback(image, info);
    }
  };
  std::shared_ptr<Pairs> pairs_;
  Subscriber image_;
  rclcpp::Subscription<Info>::SharedPtr info_;
};
}  // namespace image_transport
