// Whether the robot would touch something, after the costmap and the outline that others publish.
#pragma once
#include <string>

#include "geometry_msgs/msg/pose2_d.hpp"
#include "nav2_costmap_2d/costmap_subscriber.hpp"
#include "nav2_costmap_2d/exceptions.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav2_costmap_2d/footprint_subscriber.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d
{
class CostmapTopicCollisionChecker
{
public:
  CostmapTopicCollisionChecker(
    CostmapSubscriber & costmap_sub, FootprintSubscriber & footprint_sub, std::string name = "collision_checker")
  : name_(std::move(name)), costmap_sub_(costmap_sub), footprint_sub_(footprint_sub) {}
  /// The greatest cost below the robot at a pose; throws CollisionCheckerException where it is not known. Without
  /// `fetch_costmap_and_footprint` those of the last call count.
  double scorePose(const geometry_msgs::msg::Pose2D & pose, bool fetch_costmap_and_footprint = true);
  bool isCollisionFree(const geometry_msgs::msg::Pose2D & pose, bool fetch_costmap_and_footprint = true);

protected:
  std::string name_;
  CostmapSubscriber & costmap_sub_;
  FootprintSubscriber & footprint_sub_;
  FootprintCollisionChecker<std::shared_ptr<Costmap2D>> collision_checker_;
  rclcpp::Clock::SharedPtr clock_;
  Footprint footprint_;
};
}  // namespace nav2_costmap_2d
