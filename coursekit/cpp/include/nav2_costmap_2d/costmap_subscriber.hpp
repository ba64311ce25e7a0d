// The costmap that another node publishes.
#pragma once
#include <memory>
#include <mutex>
#include <string>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_msgs/msg/costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"

namespace nav2_costmap_2d
{
class CostmapSubscriber
{
public:
  CostmapSubscriber(const nav2_util::LifecycleNode::WeakPtr & parent, const std::string & topic_name)
  : CostmapSubscriber(*parent.lock(), topic_name) {}
  CostmapSubscriber(const rclcpp::Node::WeakPtr & parent, const std::string & topic_name)
  : CostmapSubscriber(*parent.lock(), topic_name) {}
  /// Throws std::runtime_error before the first has come.
  std::shared_ptr<Costmap2D> getCostmap();

protected:
  CostmapSubscriber(rclcpp::NodeFace & node, const std::string & topic_name);
  std::mutex lock_;
  nav2_msgs::msg::Costmap::SharedPtr heard_;
  std::shared_ptr<Costmap2D> costmap_;
  rclcpp::Subscription<nav2_msgs::msg::Costmap>::SharedPtr subscription_;
};
}  // namespace nav2_costmap_2d
