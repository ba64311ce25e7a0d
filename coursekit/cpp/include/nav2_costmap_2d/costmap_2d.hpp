// A grid of costs, and where it lies in the world.
#pragma once
#include <algorithm>
#include <climits>
#include <cmath>
#include <cstdlib>
#include <mutex>
#include <string>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "nav2_costmap_2d/cost_values.hpp"
#include "nav_msgs/msg/occupancy_grid.hpp"

namespace nav2_costmap_2d
{
/// A cell's column and row.
struct MapLocation
{
  unsigned int x;
  unsigned int y;
};

class Costmap2D
{
public:
  Costmap2D() = default;
  Costmap2D(
    unsigned int cells_size_x, unsigned int cells_size_y, double resolution, double origin_x, double origin_y,
    unsigned char default_value = 0);
  explicit Costmap2D(const nav_msgs::msg::OccupancyGrid & map);
  Costmap2D(const Costmap2D & map) {*this = map;}
  Costmap2D & operator=(const Costmap2D & map);
  virtual ~Costmap2D();

  /// Become a part of another map, in its world's units; false where that reaches beyond it.
  bool copyCostmapWindow(
    const Costmap2D & map, double win_origin_x, double win_origin_y, double win_size_x, double win_size_y);
  /// Take the cells of a part of another map; false where it reaches beyond one of them.
  bool copyWindow(
    const Costmap2D & source, unsigned int sx0, unsigned int sy0, unsigned int sxn, unsigned int syn, unsigned int dx0,
    unsigned int dy0);

  unsigned char getCost(unsigned int mx, unsigned int my) const {return costmap_[getIndex(mx, my)];}
  unsigned char getCost(unsigned int index) const {return costmap_[index];}
  void setCost(unsigned int mx, unsigned int my, unsigned char cost) {costmap_[getIndex(mx, my)] = cost;}

  /// The middle of a cell.
  void mapToWorld(unsigned int mx, unsigned int my, double & wx, double & wy) const
  {
    wx = origin_x_ + (mx + 0.5) * resolution_;
    wy = origin_y_ + (my + 0.5) * resolution_;
  }
  /// The cell of a place; false where that is not on the map.
  bool worldToMap(double wx, double wy, unsigned int & mx, unsigned int & my) const;
  void worldToMapNoBounds(double wx, double wy, int & mx, int & my) const;
  /// The cell of a place, or the nearest one on the map's edge.
  void worldToMapEnforceBounds(double wx, double wy, int & mx, int & my) const;
  unsigned int getIndex(unsigned int mx, unsigned int my) const {return my * size_x_ + mx;}
  void indexToCells(unsigned int index, unsigned int & mx, unsigned int & my) const
  {
    my = index / size_x_;
    mx = index % size_x_;
  }

  unsigned char * getCharMap() const {return costmap_;}
  unsigned int getSizeInCellsX() const {return size_x_;}
  unsigned int getSizeInCellsY() const {return size_y_;}
  /// From the first cell's corner to the last one's middle.
  double getSizeInMetersX() const {return (size_x_ - 0.5) * resolution_;}
  double getSizeInMetersY() const {return (size_y_ - 0.5) * resolution_;}
  double getOriginX() const {return origin_x_;}
  double getOriginY() const {return origin_y_;}
  double getResolution() const {return resolution_;}
  void setDefaultValue(unsigned char c) {default_value_ = c;}
  unsigned char getDefaultValue() {return default_value_;}

  /// Give a cost to all cells of a polygon; false where a corner is not on the map.
  bool setConvexPolygonCost(const std::vector<geometry_msgs::msg::Point> & polygon, unsigned char cost_value);
  void polygonOutlineCells(const std::vector<MapLocation> & polygon, std::vector<MapLocation> & polygon_cells);
  void convexFillCells(const std::vector<MapLocation> & polygon, std::vector<MapLocation> & polygon_cells);

  /// Move to another place, by whole cells; what lies in both stays.
  virtual void updateOrigin(double new_origin_x, double new_origin_y);
  /// Write a picture of the costs, in the format PGM.
  bool saveMap(std::string file_name);
  void resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x, double origin_y);
  void resetMap(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn)
  {
    resetMapToValue(x0, y0, xn, yn, default_value_);
  }
  void resetMapToValue(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn, unsigned char value);
  /// How many cells a distance is.
  unsigned int cellDistance(double world_dist);

  typedef std::recursive_mutex mutex_t;
  mutex_t * getMutex() {return &access_;}

protected:
  friend class Costmap2DROS;
  template<typename data_type>
  void copyMapRegion(
    data_type * source_map, unsigned int sm_lower_left_x, unsigned int sm_lower_left_y, unsigned int sm_size_x,
    data_type * dest_map, unsigned int dm_lower_left_x, unsigned int dm_lower_left_y, unsigned int dm_size_x,
    unsigned int region_size_x, unsigned int region_size_y)
  {
    data_type * from = source_map + sm_lower_left_y * sm_size_x + sm_lower_left_x;
    data_type * to = dest_map + dm_lower_left_y * dm_size_x + dm_lower_left_x;
    for (unsigned int row = 0; row < region_size_y; ++row, from += sm_size_x, to += dm_size_x) {
      std::copy_n(from, region_size_x, to);
    }
  }
  virtual void deleteMaps();
  virtual void resetMaps();
  virtual void initMaps(unsigned int size_x, unsigned int size_y);

  /// Call `at` with the index of each cell of a line, from a least to a greatest distance from its start, in cells.
  template<class ActionType>
  void raytraceLine(
    ActionType at, unsigned int x0, unsigned int y0, unsigned int x1, unsigned int y1, unsigned int max_length = UINT_MAX,
    unsigned int min_length = 0)
  {
    const int wide = static_cast<int>(x1) - static_cast<int>(x0), high = static_cast<int>(y1) - static_cast<int>(y0);
    const int steps = std::max(std::abs(wide), std::abs(high));
    const double length = std::hypot(wide, high);
    if (length < min_length) {
      return;
    }
    const double share = length == 0.0 ? 1.0 : std::min(1.0, max_length / length);
    const int first = length == 0.0 ? 0 : static_cast<int>(min_length / length * steps);
    for (int step = first; step <= static_cast<int>(share * steps); ++step) {
      const double part = steps ? static_cast<double>(step) / steps : 0.0;
      const long x = std::lround(x0 + part * wide), y = std::lround(y0 + part * high);
      at(getIndex(static_cast<unsigned int>(x), static_cast<unsigned int>(y)));
    }
  }

  /// Gives cells a value.
  class MarkCell
  {
  public:
    MarkCell(unsigned char * costmap, unsigned char value)
    : costmap_(costmap), value_(value) {}
    void operator()(unsigned int offset) {costmap_[offset] = value_;}

  private:
    unsigned char * costmap_;
    unsigned char value_;
  };

  mutex_t access_;
  unsigned int size_x_ = 0;
  unsigned int size_y_ = 0;
  double resolution_ = 0.0;
  double origin_x_ = 0.0;
  double origin_y_ = 0.0;
  unsigned char * costmap_ = nullptr;
  unsigned char default_value_ = 0;
};
}  // namespace nav2_costmap_2d
