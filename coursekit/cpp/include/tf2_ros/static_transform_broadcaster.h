// Says once where frames are that do not move; who comes later hears all that was said.
#pragma once
#include <algorithm>

#include "tf2_ros/transform_broadcaster.h"

namespace tf2_ros
{
class StaticTransformBroadcaster
{
public:
  using SharedPtr = std::shared_ptr<StaticTransformBroadcaster>;
  template<class N>
  explicit StaticTransformBroadcaster(
    N && node, const rclcpp::QoS & qos = StaticBroadcasterQoS(), const rclcpp::PublisherOptions & options = to_all())
  : publisher_(rclcpp::create_publisher<tf2_msgs::msg::TFMessage>(node, "/tf_static", qos, options)) {}
  void sendTransform(const geometry_msgs::msg::TransformStamped & transform) {sendTransform(std::vector{transform});}
  void sendTransform(const std::vector<geometry_msgs::msg::TransformStamped> & transforms)
  {
    for (auto & transform : transforms) {
      auto & all = said_.transforms;
      auto same = [&](auto & other) {return other.child_frame_id == transform.child_frame_id;};
      auto found = std::find_if(all.begin(), all.end(), same);
      if (found == all.end()) {
        all.push_back(transform);
      } else {
        *found = transform;
      }
    }
    publisher_->publish(said_);
  }

private:
  static rclcpp::PublisherOptions to_all()
  {
    rclcpp::PublisherOptions options;
    options.use_intra_process_comm = rclcpp::IntraProcessSetting::Disable;  // what is latched cannot stay in the program
    return options;
  }
  rclcpp::Publisher<tf2_msgs::msg::TFMessage>::SharedPtr publisher_;
  tf2_msgs::msg::TFMessage said_;
};
}  // namespace tf2_ros
