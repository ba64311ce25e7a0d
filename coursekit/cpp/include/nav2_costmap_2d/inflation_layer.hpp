// A layer that spreads costs around obstacles.
#pragma once
#include <cmath>
#include <mutex>

#include "nav2_costmap_2d/layer.hpp"

namespace nav2_costmap_2d
{
class InflationLayer : public Layer
{
public:
  using mutex_t = std::recursive_mutex;

  void onInitialize() override;
  void reset() override {matchSize();}
  bool isClearable() override {return false;}
  /// Widen the bounds by the radius: obstacles outside of them reach into them.
  void updateBounds(
    double robot_x, double robot_y, double robot_yaw, double * min_x, double * min_y, double * max_x, double * max_y) override;
  void updateCosts(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j) override;
  void matchSize() override;
  void onFootprintChanged() override;
  /// The cost of a cell so many cells away from an obstacle.
  virtual unsigned char computeCost(double distance) const
  {
    if (distance == 0.0) {
      return LETHAL_OBSTACLE;
    }
    const double beyond = distance * resolution_ - inscribed_radius_;
    return beyond <= 0.0 ? INSCRIBED_INFLATED_OBSTACLE : static_cast<unsigned char>(
      (INSCRIBED_INFLATED_OBSTACLE - 1) * std::exp(-cost_scaling_factor_ * beyond));
  }
  double getCostScalingFactor() {return cost_scaling_factor_;}
  double getInflationRadius() {return inflation_radius_;}
  mutex_t * getMutex() {return &access_;}

protected:
  /// The cost of a cell that had one, now that an obstacle is near.
  unsigned char raised(unsigned char old_cost, unsigned char cost) const;

  double inflation_radius_ = 0.0, inscribed_radius_ = 0.0, cost_scaling_factor_ = 0.0, resolution_ = 0.0;
  bool inflate_unknown_ = false, inflate_around_unknown_ = false;
  int cell_inflation_radius_ = 0;

private:
  /// Raise the costs around an obstacle, within these columns and rows.
  void spread(Costmap2D & master_grid, int column, int row, int min_i, int min_j, int max_i, int max_j);
  mutex_t access_;
};
}  // namespace nav2_costmap_2d
