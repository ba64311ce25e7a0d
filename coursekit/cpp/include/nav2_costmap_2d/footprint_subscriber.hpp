// The robot's outline that another node publishes.
#pragma once
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry_msgs/msg/polygon_stamped.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_costmap_2d
{
class FootprintSubscriber
{
public:
  FootprintSubscriber(
    const nav2_util::LifecycleNode::WeakPtr & parent, const std::string & topic_name, tf2_ros::Buffer & tf,
    std::string robot_base_frame = "base_link", double transform_tolerance = 0.1)
  : FootprintSubscriber(*parent.lock(), topic_name, tf, robot_base_frame, transform_tolerance) {}
  FootprintSubscriber(
    const rclcpp::Node::WeakPtr & parent, const std::string & topic_name, tf2_ros::Buffer & tf,
    std::string robot_base_frame = "base_link", double transform_tolerance = 0.1)
  : FootprintSubscriber(*parent.lock(), topic_name, tf, robot_base_frame, transform_tolerance) {}
  /// The last outline as it came; false before the first.
  bool getFootprintRaw(std::vector<geometry_msgs::msg::Point> & footprint, std_msgs::msg::Header & footprint_header);
  /// The last outline about the robot's centre; false where it or its transform is missing.
  bool getFootprintInRobotFrame(
    std::vector<geometry_msgs::msg::Point> & footprint, std_msgs::msg::Header & footprint_header);

protected:
  FootprintSubscriber(
    rclcpp::NodeFace & node, const std::string & topic_name, tf2_ros::Buffer & tf, std::string robot_base_frame,
    double transform_tolerance);
  std::mutex lock_;
  tf2_ros::Buffer & tf_;
  std::string robot_base_frame_;
  double transform_tolerance_;
  geometry_msgs::msg::PolygonStamped::SharedPtr footprint_;
  rclcpp::Subscription<geometry_msgs::msg::PolygonStamped>::SharedPtr subscription_;
};
}  // namespace nav2_costmap_2d
