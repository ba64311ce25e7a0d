// A costmap and the layers that it is made of.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "nav2_costmap_2d/cost_values.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/layer.hpp"

namespace nav2_costmap_2d
{
class Layer;

class LayeredCostmap
{
public:
  LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown);

  /// Have all layers of this program update their part of it.
  void updateMap(double robot_x, double robot_y, double robot_yaw);
  std::string getGlobalFrameID() const {return global_frame_;}
  void resizeMap(
    unsigned int size_x, unsigned int size_y, double resolution, double origin_x, double origin_y, bool size_locked = false);
  void getUpdatedBounds(double & minx, double & miny, double & maxx, double & maxy);
  bool isCurrent();
  Costmap2D * getCostmap() {return &costmap_;}
  bool isRolling() {return rolling_window_;}
  bool isTrackingUnknown() {return costmap_.getDefaultValue() == NO_INFORMATION;}
  std::vector<std::shared_ptr<Layer>> * getPlugins() {return &plugins_;}
  std::vector<std::shared_ptr<Layer>> * getFilters() {return &filters_;}
  void addPlugin(std::shared_ptr<Layer> plugin) {plugins_.push_back(std::move(plugin));}
  void addFilter(std::shared_ptr<Layer> filter) {filters_.push_back(std::move(filter));}
  bool isSizeLocked() {return size_locked_;}
  void getBounds(unsigned int * x0, unsigned int * xn, unsigned int * y0, unsigned int * yn);
  bool isInitialized() {return initialized_;}
  void setFootprint(const std::vector<geometry_msgs::msg::Point> & footprint_spec);
  const std::vector<geometry_msgs::msg::Point> & getFootprint() {return footprint_;}
  double getCircumscribedRadius() {return circumscribed_radius_;}
  double getInscribedRadius() {return inscribed_radius_;}
  bool isOutofBounds(double robot_x, double robot_y);

private:
  Costmap2D costmap_;
  std::string global_frame_;
  bool rolling_window_;
  bool size_locked_ = false;
  bool initialized_ = false;
  double minx_ = 0.0, miny_ = 0.0, maxx_ = 0.0, maxy_ = 0.0;
  unsigned int bx0_ = 0, bxn_ = 0, by0_ = 0, byn_ = 0;
  double circumscribed_radius_ = 1.0, inscribed_radius_ = 0.1;
  std::vector<std::shared_ptr<Layer>> plugins_;
  std::vector<std::shared_ptr<Layer>> filters_;
  std::vector<geometry_msgs::msg::Point> footprint_;
};
}  // namespace nav2_costmap_2d
