// What behavior_server asks of a behaviour, which has its own action.
#pragma once
#include <memory>
#include <string>

#include "nav2_costmap_2d/costmap_topic_collision_checker.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rclcpp_lifecycle/lifecycle_node.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_core
{
class Behavior
{
public:
  using Ptr = std::shared_ptr<Behavior>;
  virtual ~Behavior() = default;

  virtual void configure(
    const rclcpp_lifecycle::LifecycleNode::WeakPtr & parent, const std::string & name, std::shared_ptr<tf2_ros::Buffer> tf,
    std::shared_ptr<nav2_costmap_2d::CostmapTopicCollisionChecker> collision_checker) = 0;
  virtual void cleanup() = 0;
  virtual void activate() = 0;
  virtual void deactivate() = 0;
};
}  // namespace nav2_core
