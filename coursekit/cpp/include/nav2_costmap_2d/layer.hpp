// A layer of a costmap.
#pragma once
#include <string>
#include <unordered_set>
#include <vector>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"
#include "nav2_util/lifecycle_node.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

namespace nav2_costmap_2d
{
class LayeredCostmap;

class Layer
{
public:
  Layer() = default;
  virtual ~Layer() = default;

  void initialize(
    LayeredCostmap * parent, std::string name, tf2_ros::Buffer * tf, const nav2_util::LifecycleNode::WeakPtr & node,
    rclcpp::CallbackGroup::SharedPtr callback_group);
  virtual void deactivate() {}
  virtual void activate() {}
  virtual void reset() = 0;
  virtual bool isClearable() = 0;
  /// Widen the bounds by what the layer will change for a robot at this pose.
  virtual void updateBounds(
    double robot_x, double robot_y, double robot_yaw, double * min_x, double * min_y, double * max_x, double * max_y) = 0;
  /// Change the cells of these columns and rows, up to the last without it.
  virtual void updateCosts(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j) = 0;
  /// Called when the costmap's size has changed.
  virtual void matchSize() {}
  virtual void onFootprintChanged() {}

  std::string getName() const {return name_;}
  bool isCurrent() const {return current_;}
  bool isEnabled() const {return enabled_;}
  const std::vector<geometry_msgs::msg::Point> & getFootprint() const;
  void declareParameter(const std::string & param_name, const rclcpp::ParameterValue & value);
  void declareParameter(const std::string & param_name, const rclcpp::ParameterType & param_type);
  bool hasParameter(const std::string & param_name);
  void undeclareAllParameters();
  /// The name of a parameter of this layer, among those of the node.
  std::string getFullName(const std::string & param_name) {return name_ + "." + param_name;}

protected:
  virtual void onInitialize() {}

  LayeredCostmap * layered_costmap_ = nullptr;
  std::string name_;
  tf2_ros::Buffer * tf_ = nullptr;
  rclcpp::CallbackGroup::SharedPtr callback_group_;
  rclcpp_lifecycle::LifecycleNode::WeakPtr node_;
  rclcpp::Clock::SharedPtr clock_;
  rclcpp::Logger logger_{rclcpp::get_logger("nav2_costmap_2d")};
  bool current_ = false;
  bool enabled_ = false;
  std::unordered_set<std::string> local_params_;
};
}  // namespace nav2_costmap_2d
