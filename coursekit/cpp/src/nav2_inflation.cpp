// The layer that spreads costs around obstacles.
#include "nav2_costmap_2d/inflation_layer.hpp"

namespace nav2_costmap_2d
{
void InflationLayer::onInitialize()
{
  declareParameter("enabled", rclcpp::ParameterValue(true));
  declareParameter("inflation_radius", rclcpp::ParameterValue(0.55));
  declareParameter("cost_scaling_factor", rclcpp::ParameterValue(10.0));
  declareParameter("inflate_unknown", rclcpp::ParameterValue(false));
  declareParameter("inflate_around_unknown", rclcpp::ParameterValue(false));
  auto node = node_.lock();
  node->get_parameter(getFullName("enabled"), enabled_);
  node->get_parameter(getFullName("inflation_radius"), inflation_radius_);
  node->get_parameter(getFullName("cost_scaling_factor"), cost_scaling_factor_);
  node->get_parameter(getFullName("inflate_unknown"), inflate_unknown_);
  node->get_parameter(getFullName("inflate_around_unknown"), inflate_around_unknown_);
  current_ = true;
  matchSize();
}
void InflationLayer::matchSize()
{
  std::lock_guard<mutex_t> hold(access_);
  resolution_ = layered_costmap_->getCostmap()->getResolution();
  cell_inflation_radius_ = static_cast<int>(layered_costmap_->getCostmap()->cellDistance(inflation_radius_));
  inscribed_radius_ = layered_costmap_->getInscribedRadius();
}
void InflationLayer::onFootprintChanged()
{
  matchSize();
  if (inflation_radius_ < inscribed_radius_) {
    RCLCPP_ERROR(
      logger_, "The configured inflation radius (%.3f) is smaller than the computed inscribed radius (%.3f) of your footprint, "
      "it is highly recommended to set inflation radius to be at least as big as the inscribed radius to avoid collisions",
      inflation_radius_, inscribed_radius_);
  }
}
void InflationLayer::updateBounds(double, double, double, double * min_x, double * min_y, double * max_x, double * max_y)
{
  *min_x -= inflation_radius_;
  *min_y -= inflation_radius_;
  *max_x += inflation_radius_;
  *max_y += inflation_radius_;
}
unsigned char InflationLayer::raised(unsigned char old_cost, unsigned char cost) const
{
  if (old_cost != NO_INFORMATION) {
    return std::max(old_cost, cost);
  }
  const bool known = inflate_unknown_ ? cost > FREE_SPACE : cost >= INSCRIBED_INFLATED_OBSTACLE;
  return known ? cost : old_cost;
}
void InflationLayer::spread(Costmap2D & master_grid, int column, int row, int min_i, int min_j, int max_i, int max_j)
{
  const int reach = cell_inflation_radius_;
  for (int j = std::max(min_j, row - reach); j < std::min(max_j, row + reach + 1); ++j) {
    for (int i = std::max(min_i, column - reach); i < std::min(max_i, column + reach + 1); ++i) {
      const double distance = std::hypot(i - column, j - row);
      if (distance <= reach) {
        master_grid.setCost(i, j, raised(master_grid.getCost(i, j), computeCost(distance)));
      }
    }
  }
}
void InflationLayer::updateCosts(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j)
{
  std::lock_guard<mutex_t> hold(access_);
  if (!enabled_ || cell_inflation_radius_ == 0) {
    return;
  }
  const Costmap2D before(master_grid);
  const int reach = cell_inflation_radius_;
  const int width = static_cast<int>(before.getSizeInCellsX()), height = static_cast<int>(before.getSizeInCellsY());
  for (int j = std::max(0, min_j - reach); j < std::min(height, max_j + reach); ++j) {
    for (int i = std::max(0, min_i - reach); i < std::min(width, max_i + reach); ++i) {
      const unsigned char cost = before.getCost(i, j);
      if (cost == LETHAL_OBSTACLE || (inflate_around_unknown_ && cost == NO_INFORMATION)) {
        spread(master_grid, i, j, min_i, min_j, max_i, max_j);
      }
    }
  }
  current_ = true;
}
}  // namespace nav2_costmap_2d
