// A layer that keeps costs of its own.
#pragma once
#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_costmap_2d/layer.hpp"
#include "nav2_costmap_2d/layered_costmap.hpp"

namespace nav2_costmap_2d
{
class CostmapLayer : public Layer, public Costmap2D
{
public:
  bool isDiscretized() {return true;}
  void matchSize() override;
  /// Forget the costs in a part of the world; with `invert` those outside.
  virtual void clearArea(int start_x, int start_y, int end_x, int end_y, bool invert);
  /// Have the next bounds reach at least this far.
  void addExtraBounds(double mx0, double my0, double mx1, double my1);

protected:
  void updateWithTrueOverwrite(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithOverwrite(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithMax(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j);
  void updateWithAddition(Costmap2D & master_grid, int min_i, int min_j, int max_i, int max_j);
  /// Widen bounds by a point.
  void touch(double x, double y, double * min_x, double * min_y, double * max_x, double * max_y);
  void useExtraBounds(double * min_x, double * min_y, double * max_x, double * max_y);
  bool has_extra_bounds_ = false;

private:
  double extra_min_x_ = 1e6, extra_max_x_ = -1e6, extra_min_y_ = 1e6, extra_max_y_ = -1e6;
};
}  // namespace nav2_costmap_2d
