// Layers of costmaps.
#include "nav2_costmap_2d/costmap_layer.hpp"

#include "nav2_costmap_2d/footprint.hpp"

namespace nav2_costmap_2d
{
using geometry_msgs::msg::Point;

// -- a layer

void Layer::initialize(
  LayeredCostmap * parent, std::string name, tf2_ros::Buffer * tf, const nav2_util::LifecycleNode::WeakPtr & node,
  rclcpp::CallbackGroup::SharedPtr callback_group)
{
  layered_costmap_ = parent;
  name_ = std::move(name);
  tf_ = tf;
  callback_group_ = std::move(callback_group);
  auto shared = node.lock();
  node_ = shared;
  logger_ = shared->get_logger();
  clock_ = shared->get_clock();
  onInitialize();
}
const std::vector<Point> & Layer::getFootprint() const {return layered_costmap_->getFootprint();}
void Layer::declareParameter(const std::string & param_name, const rclcpp::ParameterValue & value)
{
  local_params_.insert(param_name);
  nav2_util::declare_parameter_if_not_declared(node_.lock(), getFullName(param_name), value);
}
void Layer::declareParameter(const std::string & param_name, const rclcpp::ParameterType & param_type)
{
  local_params_.insert(param_name);
  nav2_util::declare_parameter_if_not_declared(node_.lock(), getFullName(param_name), param_type);
}
bool Layer::hasParameter(const std::string & param_name) {return node_.lock()->has_parameter(getFullName(param_name));}
void Layer::undeclareAllParameters()
{
  for (auto & name : local_params_) {
    node_.lock()->undeclare_parameter(getFullName(name));
  }
  local_params_.clear();
}

// -- a layer with costs

void CostmapLayer::matchSize()
{
  Costmap2D * all = layered_costmap_->getCostmap();
  resizeMap(
    all->getSizeInCellsX(), all->getSizeInCellsY(), all->getResolution(), all->getOriginX(), all->getOriginY());
}
void CostmapLayer::clearArea(int start_x, int start_y, int end_x, int end_y, bool invert)
{
  current_ = false;
  for (int y = 0; y < static_cast<int>(size_y_); ++y) {
    for (int x = 0; x < static_cast<int>(size_x_); ++x) {
      const bool inside = x >= start_x && x < end_x && y >= start_y && y < end_y;
      if (inside != invert) {
        costmap_[y * size_x_ + x] = NO_INFORMATION;
      }
    }
  }
}
void CostmapLayer::addExtraBounds(double mx0, double my0, double mx1, double my1)
{
  extra_min_x_ = std::min(mx0, extra_min_x_);
  extra_max_x_ = std::max(mx1, extra_max_x_);
  extra_min_y_ = std::min(my0, extra_min_y_);
  extra_max_y_ = std::max(my1, extra_max_y_);
  has_extra_bounds_ = true;
}
void CostmapLayer::useExtraBounds(double * min_x, double * min_y, double * max_x, double * max_y)
{
  if (has_extra_bounds_) {
    touch(extra_min_x_, extra_min_y_, min_x, min_y, max_x, max_y);
    touch(extra_max_x_, extra_max_y_, min_x, min_y, max_x, max_y);
    extra_min_x_ = extra_min_y_ = 1e6;
    extra_max_x_ = extra_max_y_ = -1e6;
    has_extra_bounds_ = false;
  }
}
void CostmapLayer::touch(double x, double y, double * min_x, double * min_y, double * max_x, double * max_y)
{
  *min_x = std::min(x, *min_x);
  *min_y = std::min(y, *min_y);
  *max_x = std::max(x, *max_x);
  *max_y = std::max(y, *max_y);
}

/// Give each master cell of a part what a function makes of it and of the layer's cell.
template<class F>
static void merge(const Costmap2D & layer, Costmap2D & master, int min_i, int min_j, int max_i, int max_j, F merged)
{
  for (int j = min_j; j < max_j; ++j) {
    for (int i = min_i; i < max_i; ++i) {
      unsigned char & cell = master.getCharMap()[master.getIndex(i, j)];
      cell = merged(cell, layer.getCost(i, j));
    }
  }
}
void CostmapLayer::updateWithTrueOverwrite(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j)
{
  if (enabled_) {
    merge(*this, master_grid, min_i, min_j, max_i, max_j, [](int, int own) {return static_cast<unsigned char>(own);});
  }
}
void CostmapLayer::updateWithOverwrite(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j)
{
  if (enabled_) {
    merge(
      *this, master_grid, min_i, min_j, max_i, max_j,
      [](int below, int own) {return static_cast<unsigned char>(own == NO_INFORMATION ? below : own);});
  }
}
void CostmapLayer::updateWithMax(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j)
{
  if (enabled_) {
    merge(
      *this, master_grid, min_i, min_j, max_i, max_j, [](int below, int own) {
        const bool wins = own != NO_INFORMATION && (below == NO_INFORMATION || below < own);
        return static_cast<unsigned char>(wins ? own : below);
      });
  }
}
void CostmapLayer::updateWithAddition(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j)
{
  if (enabled_) {
    merge(
      *this, master_grid, min_i, min_j, max_i, max_j, [](int below, int own) {
        const int sum = std::min(below + own, static_cast<int>(MAX_NON_OBSTACLE));
        const int known = below == NO_INFORMATION ? own : std::max(below, sum);
        return static_cast<unsigned char>(own == NO_INFORMATION ? below : known);
      });
  }
}

// -- all layers

LayeredCostmap::LayeredCostmap(std::string global_frame, bool rolling_window, bool track_unknown)
: global_frame_(std::move(global_frame)), rolling_window_(rolling_window)
{
  costmap_.setDefaultValue(track_unknown ? NO_INFORMATION : FREE_SPACE);
}
void LayeredCostmap::resizeMap(
  unsigned int size_x, unsigned int size_y, double resolution, double origin_x, double origin_y, bool size_locked)
{
  size_locked_ = size_locked;
  costmap_.resizeMap(size_x, size_y, resolution, origin_x, origin_y);
  for (auto & layer : plugins_) {
    layer->matchSize();
  }
}
void LayeredCostmap::updateMap(double robot_x, double robot_y, double robot_yaw)
{
  // The server's own layers have made all of it anew.
  minx_ = costmap_.getOriginX();
  miny_ = costmap_.getOriginY();
  maxx_ = minx_ + costmap_.getSizeInMetersX();
  maxy_ = miny_ + costmap_.getSizeInMetersY();
  for (auto & layer : plugins_) {
    layer->updateBounds(robot_x, robot_y, robot_yaw, &minx_, &miny_, &maxx_, &maxy_);
  }
  int x0, y0, xn, yn;
  costmap_.worldToMapEnforceBounds(minx_, miny_, x0, y0);
  costmap_.worldToMapEnforceBounds(maxx_, maxy_, xn, yn);
  xn = std::min(static_cast<int>(costmap_.getSizeInCellsX()), xn + 1);
  yn = std::min(static_cast<int>(costmap_.getSizeInCellsY()), yn + 1);
  initialized_ = true;
  if (xn < x0 || yn < y0) {
    return;
  }
  for (auto & layer : plugins_) {
    layer->updateCosts(costmap_, x0, y0, xn, yn);
  }
  bx0_ = static_cast<unsigned int>(x0);
  bxn_ = static_cast<unsigned int>(xn);
  by0_ = static_cast<unsigned int>(y0);
  byn_ = static_cast<unsigned int>(yn);
}
void LayeredCostmap::getUpdatedBounds(double & minx, double & miny, double & maxx, double & maxy)
{
  minx = minx_;
  miny = miny_;
  maxx = maxx_;
  maxy = maxy_;
}
void LayeredCostmap::getBounds(unsigned int * x0, unsigned int * xn, unsigned int * y0, unsigned int * yn)
{
  *x0 = bx0_;
  *xn = bxn_;
  *y0 = by0_;
  *yn = byn_;
}
bool LayeredCostmap::isCurrent()
{
  return std::all_of(plugins_.begin(), plugins_.end(), [](auto & one) {return one->isCurrent() || !one->isEnabled();});
}
bool LayeredCostmap::isOutofBounds(double robot_x, double robot_y)
{
  unsigned int x, y;
  return !costmap_.worldToMap(robot_x, robot_y, x, y);
}
void LayeredCostmap::setFootprint(const std::vector<Point> & footprint_spec)
{
  if (footprint_ == footprint_spec) {
    return;
  }
  footprint_ = footprint_spec;
  std::tie(inscribed_radius_, circumscribed_radius_) = calculateMinAndMaxDistances(footprint_spec);
  for (auto & layer : plugins_) {
    layer->onFootprintChanged();
  }
}
}  // namespace nav2_costmap_2d
