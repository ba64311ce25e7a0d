// Says where frames are that move.
#pragma once
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_msgs/msg/tf_message.hpp"
#include "tf2_ros/qos.hpp"

namespace tf2_ros
{
class TransformBroadcaster
{
public:
  using SharedPtr = std::shared_ptr<TransformBroadcaster>;
  template<class N>
  explicit TransformBroadcaster(
    N && node, const rclcpp::QoS & qos = DynamicBroadcasterQoS(), const rclcpp::PublisherOptions & options = {})
  : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(node, "/tf", qos, options)) {}
  void sendTransform(const geometry_msgs::msg::TransformStamped & transform) {sendTransform(std::vector{transform});}
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> & transforms)
  {
    publisher_->publish(tf2_msgs::msg::TFMessage().set__transforms(transforms));
  }

private:
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
};
}  // namespace tf2_ros
