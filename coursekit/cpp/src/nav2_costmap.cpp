// Costmaps: grids of costs.
#include <fstream>

#include "nav2_costmap_2d/costmap_2d.hpp"
#include "nav2_util/line_iterator.hpp"

namespace nav2_costmap_2d
{
using geometry_msgs::msg::Point;

Costmap2D::Costmap2D(
  unsigned int cells_size_x, unsigned int cells_size_y, double resolution, double origin_x, double origin_y,
  unsigned char default_value)
: default_value_(default_value)
{
  Costmap2D::resizeMap(cells_size_x, cells_size_y, resolution, origin_x, origin_y);
}
Costmap2D::Costmap2D(const nav_msgs::msg::OccupancyGrid & map)
: Costmap2D(
    map.info.width, map.info.height, map.info.resolution, map.info.origin.position.x, map.info.origin.position.y, FREE_SPACE)
{
  for (size_t i = 0; i < map.data.size(); ++i) {
    const int8_t share = map.data[i];
    const bool known = share >= 0;
    costmap_[i] = known ? static_cast<unsigned char>(std::lround(share * (LETHAL_OBSTACLE / 100.0))) : NO_INFORMATION;
  }
}
Costmap2D & Costmap2D::operator=(const Costmap2D & map)
{
  if (this != &map) {
    default_value_ = map.default_value_;
    Costmap2D::resizeMap(map.size_x_, map.size_y_, map.resolution_, map.origin_x_, map.origin_y_);
    std::copy_n(map.costmap_, static_cast<size_t>(size_x_) * size_y_, costmap_);
  }
  return *this;
}
Costmap2D::~Costmap2D() {delete[] costmap_;}

void Costmap2D::deleteMaps()
{
  std::lock_guard<mutex_t> hold(access_);
  delete[] costmap_;
  costmap_ = nullptr;
}
void Costmap2D::initMaps(unsigned int size_x, unsigned int size_y)
{
  std::lock_guard<mutex_t> hold(access_);
  delete[] costmap_;
  size_x_ = size_x;
  size_y_ = size_y;
  costmap_ = new unsigned char[static_cast<size_t>(size_x) * size_y];
}
void Costmap2D::resetMaps()
{
  std::lock_guard<mutex_t> hold(access_);
  std::fill_n(costmap_, static_cast<size_t>(size_x_) * size_y_, default_value_);
}
void Costmap2D::resizeMap(unsigned int size_x, unsigned int size_y, double resolution, double origin_x, double origin_y)
{
  resolution_ = resolution;
  origin_x_ = origin_x;
  origin_y_ = origin_y;
  initMaps(size_x, size_y);
  resetMaps();
}
void Costmap2D::resetMapToValue(unsigned int x0, unsigned int y0, unsigned int xn, unsigned int yn, unsigned char value)
{
  std::lock_guard<mutex_t> hold(access_);
  for (unsigned int row = y0; row < yn && x0 < xn; ++row) {
    std::fill_n(costmap_ + getIndex(x0, row), xn - x0, value);
  }
}
bool Costmap2D::copyCostmapWindow(
  const Costmap2D & map, double win_origin_x, double win_origin_y, double win_size_x, double win_size_y)
{
  unsigned int x0, y0, xn, yn;
  const double end_x = win_origin_x + win_size_x, end_y = win_origin_y + win_size_y;
  if (this == &map || !map.worldToMap(win_origin_x, win_origin_y, x0, y0) || !map.worldToMap(end_x, end_y, xn, yn)) {
    return false;
  }
  resizeMap(xn - x0, yn - y0, map.resolution_, win_origin_x, win_origin_y);
  return copyWindow(map, x0, y0, xn, yn, 0, 0);
}
bool Costmap2D::copyWindow(
  const Costmap2D & source, unsigned int sx0, unsigned int sy0, unsigned int sxn, unsigned int syn, unsigned int dx0,
  unsigned int dy0)
{
  const unsigned int wide = sxn - sx0, high = syn - sy0;
  if (sxn > source.size_x_ || syn > source.size_y_ || dx0 + wide > size_x_ || dy0 + high > size_y_) {
    return false;
  }
  copyMapRegion(source.costmap_, sx0, sy0, source.size_x_, costmap_, dx0, dy0, size_x_, wide, high);
  return true;
}

bool Costmap2D::worldToMap(double wx, double wy, unsigned int & mx, unsigned int & my) const
{
  if (wx < origin_x_ || wy < origin_y_) {
    return false;
  }
  mx = static_cast<unsigned int>((wx - origin_x_) / resolution_);
  my = static_cast<unsigned int>((wy - origin_y_) / resolution_);
  return mx < size_x_ && my < size_y_;
}
void Costmap2D::worldToMapNoBounds(double wx, double wy, int & mx, int & my) const
{
  mx = static_cast<int>((wx - origin_x_) / resolution_);
  my = static_cast<int>((wy - origin_y_) / resolution_);
}
void Costmap2D::worldToMapEnforceBounds(double wx, double wy, int & mx, int & my) const
{
  auto nearest = [this](double distance, unsigned int size) {
      return static_cast<int>(std::clamp(distance / resolution_, 0.0, static_cast<double>(size) - 1.0));
    };
  mx = nearest(wx - origin_x_, size_x_);
  my = nearest(wy - origin_y_, size_y_);
}
unsigned int Costmap2D::cellDistance(double world_dist)
{
  return static_cast<unsigned int>(std::max(0.0, std::ceil(world_dist / resolution_)));
}
void Costmap2D::updateOrigin(double new_origin_x, double new_origin_y)
{
  const int right = static_cast<int>((new_origin_x - origin_x_) / resolution_);
  const int up = static_cast<int>((new_origin_y - origin_y_) / resolution_);
  const int wide = static_cast<int>(size_x_), high = static_cast<int>(size_y_);
  const Costmap2D before(*this);
  origin_x_ += right * resolution_;
  origin_y_ += up * resolution_;
  resetMaps();
  const int x0 = std::clamp(right, 0, wide), xn = std::clamp(right + wide, 0, wide);
  const int y0 = std::clamp(up, 0, high), yn = std::clamp(up + high, 0, high);
  for (int y = y0; y < yn; ++y) {
    for (int x = x0; x < xn; ++x) {
      costmap_[(y - up) * wide + x - right] = before.costmap_[y * wide + x];
    }
  }
}
bool Costmap2D::saveMap(std::string file_name)
{
  std::ofstream file(file_name);
  file << "P2\n" << size_x_ << "\n" << size_y_ << "\n" << 0xff << "\n";
  for (unsigned int y = 0; y < size_y_; ++y) {
    for (unsigned int x = 0; x < size_x_; ++x) {
      file << static_cast<int>(getCost(x, y)) << " ";
    }
    file << "\n";
  }
  return static_cast<bool>(file);
}

// -- polygons

void Costmap2D::polygonOutlineCells(const std::vector<MapLocation> & polygon, std::vector<MapLocation> & polygon_cells)
{
  for (size_t i = 0; i < polygon.size(); ++i) {
    auto & from = polygon[i], & to = polygon[(i + 1) % polygon.size()];
    nav2_util::LineIterator line(
      static_cast<int>(from.x), static_cast<int>(from.y), static_cast<int>(to.x), static_cast<int>(to.y));
    for (; line.isValid(); line.advance()) {
      polygon_cells.push_back({static_cast<unsigned int>(line.getX()), static_cast<unsigned int>(line.getY())});
    }
  }
}
void Costmap2D::convexFillCells(const std::vector<MapLocation> & polygon, std::vector<MapLocation> & polygon_cells)
{
  if (polygon.size() < 3) {
    return;
  }
  std::vector<MapLocation> outline;
  polygonOutlineCells(polygon, outline);
  std::sort(
    outline.begin(), outline.end(),
    [](const MapLocation & a, const MapLocation & b) {return a.x < b.x || (a.x == b.x && a.y < b.y);});
  for (size_t i = 0; i < outline.size(); ) {  // a column: from its lowest cell to its highest
    size_t last = i;
    while (last + 1 < outline.size() && outline[last + 1].x == outline[i].x) {
      ++last;
    }
    for (unsigned int y = outline[i].y; y <= outline[last].y; ++y) {
      polygon_cells.push_back({outline[i].x, y});
    }
    i = last + 1;
  }
}
bool Costmap2D::setConvexPolygonCost(const std::vector<Point> & polygon, unsigned char cost_value)
{
  std::vector<MapLocation> corners, cells;
  for (auto & one : polygon) {
    MapLocation corner;
    if (!worldToMap(one.x, one.y, corner.x, corner.y)) {
      return false;
    }
    corners.push_back(corner);
  }
  convexFillCells(corners, cells);
  for (auto & cell : cells) {
    setCost(cell.x, cell.y, cost_value);
  }
  return true;
}
}  // namespace nav2_costmap_2d
