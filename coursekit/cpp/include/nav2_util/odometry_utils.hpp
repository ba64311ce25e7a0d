// The robot's velocity: the mean of what odometry said lately.
#pragma once
#include <deque>
#include <memory>
#include <mutex>
#include <string>

#include "geometry_msgs/msg/twist_stamped.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_util
{
class OdomSmoother
{
public:
  explicit OdomSmoother(
    const rclcpp::Node::WeakPtr & parent, double filter_duration = 0.3, const std::string & odom_topic = "odom")
  : OdomSmoother(*parent.lock(), filter_duration, odom_topic) {}
  explicit OdomSmoother(
    const nav2_util::LifecycleNode::WeakPtr & parent, double filter_duration = 0.3, const std::string & odom_topic = "odom")
  : OdomSmoother(*parent.lock(), filter_duration, odom_topic) {}

  geometry_msgs::msg::Twist getTwist() {return getTwistStamped().twist;}
  geometry_msgs::msg::TwistStamped getTwistStamped();

private:
  OdomSmoother(rclcpp::NodeFace & node, double filter_duration, const std::string & odom_topic);
  std::mutex lock_;
  rclcpp::Duration span_;
  std::deque<nav_msgs::msg::Odometry> heard_;
  rclcpp::Subscription<nav_msgs::msg::Odometry>::SharedPtr subscription_;
};
}  // namespace nav2_util
