// The costmap of a server, for its plugins.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/polygon.hpp"
#include "geometry_msgs/msg/pose_stamped.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_costmap_2d/layer.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "nav2_util/robot_utils.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_costmap_2d
{
/// A copy of the server's costs, which is renewed before each call of a plugin.
class Costmap2DROS : public nav2_util::LifecycleNode
{
public:
  /// The node of a server's costmap, and the server's buffer.
  Costmap2DROS(rclcpp::SharedNode node, std::shared_ptr<tf2_ros::Buffer> tf);

  std::string getName() const {return get_name();}
  Costmap2D * getCostmap() {return layered_costmap_->getCostmap();}
  LayeredCostmap * getLayeredCostmap() {return layered_costmap_.get();}
  std::shared_ptr<tf2_ros::Buffer> getTfBuffer() {return tf_buffer_;}
  std::string getGlobalFrameID() {return global_frame_;}
  std::string getBaseFrameID() {return robot_base_frame_;}
  double getTransformTolerance() const {return transform_tolerance_;}
  bool isCurrent() {return layered_costmap_->isCurrent();}

  bool getRobotPose(geometry_msgs::msg::PoseStamped & global_pose);
  bool transformPoseToGlobalFrame(
    const geometry_msgs::msg::PoseStamped & input_pose, geometry_msgs::msg::PoseStamped & transformed_pose);

  std::vector<geometry_msgs::msg::Point> getRobotFootprint() {return layered_costmap_->getFootprint();}
  geometry_msgs::msg::Polygon getRobotFootprintPolygon() {return toPolygon(getRobotFootprint());}
  std::vector<geometry_msgs::msg::Point> getUnpaddedRobotFootprint();
  /// The footprint where the robot stands.
  void getOrientedFootprint(std::vector<geometry_msgs::msg::Point> & oriented_footprint);
  /// Whether the robot is a circle.
  bool getUseRadius();
  double getRobotRadius();

  /// Take the server's costs, and the outline of the robot.
  void renew(coursekit::Unpacker & from);
  /// Make an object for each layer that the server's parameters name: getPlugins() has them.
  void meet_layers();

private:
  double number(const std::string & parameter);
  std::shared_ptr<tf2_ros::Buffer> tf_buffer_;
  std::string global_frame_, robot_base_frame_;
  double transform_tolerance_;
  std::unique_ptr<LayeredCostmap> layered_costmap_;
};
}  // namespace nav2_costmap_2d
