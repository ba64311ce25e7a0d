// The greatest cost below the outline of the robot.
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/footprint.hpp"
#include "nav2_util/line_iterator.hpp"

namespace nav2_costmap_2d
{
typedef std::vector<geometry_msgs::msg::Point> Footprint;

/// `CostmapT` is a pointer to a costmap.
template<typename CostmapT>
class FootprintCollisionChecker
{
public:
  FootprintCollisionChecker() = default;
  explicit FootprintCollisionChecker(CostmapT costmap)
  : costmap_(costmap) {}

  /// A corner that is not on the map is an obstacle.
  double footprintCost(const Footprint footprint)
  {
    double cost = 0.0;
    for (size_t i = 0; i < footprint.size(); ++i) {
      const auto & from = footprint[i], & to = footprint[(i + 1) % footprint.size()];
      unsigned int x0, y0, x1, y1;
      if (!worldToMap(from.x, from.y, x0, y0) || !worldToMap(to.x, to.y, x1, y1)) {
        return static_cast<double>(LETHAL_OBSTACLE);
      }
      cost = std::max(cost, lineCost(x0, x1, y0, y1));
      if (cost == static_cast<double>(LETHAL_OBSTACLE)) {
        return cost;
      }
    }
    return cost;
  }
  double footprintCostAtPose(double x, double y, double theta, const Footprint footprint)
  {
    Footprint oriented;
    transformFootprint(x, y, theta, footprint, oriented);
    return footprintCost(oriented);
  }
  double lineCost(int x0, int x1, int y0, int y1) const
  {
    double cost = 0.0;
    for (nav2_util::LineIterator line(x0, y0, x1, y1); line.isValid(); line.advance()) {
      cost = std::max(cost, pointCost(line.getX(), line.getY()));
    }
    return cost;
  }
  bool worldToMap(double wx, double wy, unsigned int & mx, unsigned int & my) {return costmap_->worldToMap(wx, wy, mx, my);}
  double pointCost(int x, int y) const {return costmap_->getCost(x, y);}
  void setCostmap(CostmapT costmap) {costmap_ = costmap;}
  CostmapT getCostmap() {return costmap_;}

protected:
  CostmapT costmap_{};
};
}  // namespace nav2_costmap_2d
