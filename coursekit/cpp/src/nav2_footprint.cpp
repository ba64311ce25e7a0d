// The outlines of robots, and polygons.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <iterator>
#include <limits>

#include "nav2_costmap_2d/costmap_math.hpp"
#include "nav2_costmap_2d/footprint.hpp"

namespace nav2_costmap_2d
{
using geometry_msgs::msg::Point;

std::pair<double, double> calculateMinAndMaxDistances(const std::vector<Point> & footprint)
{
  if (footprint.size() <= 2) {
    return {0.0, 0.0};
  }
  double least = std::numeric_limits<double>::max(), greatest = 0.0;
  for (size_t i = 0; i < footprint.size(); ++i) {
    auto & one = footprint[i], & next = footprint[(i + 1) % footprint.size()];
    const double corner = std::hypot(one.x, one.y);
    least = std::min({least, corner, distanceToLine(0.0, 0.0, one.x, one.y, next.x, next.y)});
    greatest = std::max(greatest, corner);
  }
  return {least, greatest};
}
Point toPoint(geometry_msgs::msg::Point32 pt)
{
  Point made;
  made.x = pt.x;
  made.y = pt.y;
  made.z = pt.z;
  return made;
}
geometry_msgs::msg::Point32 toPoint32(Point pt)
{
  geometry_msgs::msg::Point32 made;
  made.x = static_cast<float>(pt.x);
  made.y = static_cast<float>(pt.y);
  made.z = static_cast<float>(pt.z);
  return made;
}
geometry_msgs::msg::Polygon toPolygon(std::vector<Point> pts)
{
  geometry_msgs::msg::Polygon made;
  std::transform(pts.begin(), pts.end(), std::back_inserter(made.points), toPoint32);
  return made;
}
std::vector<Point> toPointVector(geometry_msgs::msg::Polygon::SharedPtr polygon)
{
  std::vector<Point> made;
  std::transform(polygon->points.begin(), polygon->points.end(), std::back_inserter(made), toPoint);
  return made;
}
void transformFootprint(
  double x, double y, double theta, const std::vector<Point> & footprint_spec, std::vector<Point> & oriented_footprint)
{
  const double c = std::cos(theta), s = std::sin(theta);
  oriented_footprint.clear();
  for (auto & one : footprint_spec) {
    Point turned;
    turned.x = x + c * one.x - s * one.y;
    turned.y = y + s * one.x + c * one.y;
    oriented_footprint.push_back(turned);
  }
}
void transformFootprint(
  double x, double y, double theta, const std::vector<Point> & footprint_spec,
  geometry_msgs::msg::PolygonStamped & oriented_footprint)
{
  std::vector<Point> turned;
  transformFootprint(x, y, theta, footprint_spec, turned);
  oriented_footprint.polygon = toPolygon(turned);
}
void padFootprint(std::vector<Point> & footprint, double padding)
{
  for (auto & one : footprint) {
    one.x += sign0(one.x) * padding;
    one.y += sign0(one.y) * padding;
  }
}
std::vector<Point> makeFootprintFromRadius(double radius)
{
  constexpr int CORNERS = 16;
  std::vector<Point> made(CORNERS);
  for (int i = 0; i < CORNERS; ++i) {
    made[i].x = radius * std::cos(i * 2 * M_PI / CORNERS);
    made[i].y = radius * std::sin(i * 2 * M_PI / CORNERS);
  }
  return made;
}
bool makeFootprintFromString(const std::string & footprint_string, std::vector<Point> & footprint)
{
  std::vector<std::vector<double>> read;
  int depth = 0;
  const char * at = footprint_string.c_str();
  while (*at) {
    char * end = nullptr;
    const double value = std::strtod(at, &end);
    if (end != at) {
      if (depth != 2) {
        return false;
      }
      read.back().push_back(value);
      at = end;
      continue;
    }
    if (*at == '[' && ++depth == 2) {
      read.emplace_back();
    } else if (*at == ']') {
      --depth;
    }
    if (depth < 0 || depth > 2 || !(std::isspace(static_cast<unsigned char>(*at)) || std::strchr("[],", *at))) {
      return false;
    }
    ++at;
  }
  if (depth != 0 || read.size() < 3 || std::any_of(read.begin(), read.end(), [](auto & one) {return one.size() != 2;})) {
    return false;
  }
  footprint.clear();
  for (auto & one : read) {
    Point corner;
    corner.x = one[0];
    corner.y = one[1];
    footprint.push_back(corner);
  }
  return true;
}
}  // namespace nav2_costmap_2d

double distanceToLine(double pX, double pY, double x0, double y0, double x1, double y1)
{
  const double wide = x1 - x0, high = y1 - y0, squared = wide * wide + high * high;
  const double along = squared > 0.0 ? std::clamp(((pX - x0) * wide + (pY - y0) * high) / squared, 0.0, 1.0) : 0.0;
  return std::hypot(pX - (x0 + along * wide), pY - (y0 + along * high));
}
bool intersects(std::vector<geometry_msgs::msg::Point> & polygon, float testx, float testy)
{
  bool inside = false;
  for (size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    auto & a = polygon[i], & b = polygon[j];
    if ((a.y > testy) != (b.y > testy) && testx < (b.x - a.x) * (testy - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}
bool intersects(std::vector<geometry_msgs::msg::Point> & polygon1, std::vector<geometry_msgs::msg::Point> & polygon2)
{
  auto any = [](std::vector<geometry_msgs::msg::Point> & polygon, std::vector<geometry_msgs::msg::Point> & corners) {
      return std::any_of(
        corners.begin(), corners.end(),
        [&](auto & one) {return intersects(polygon, static_cast<float>(one.x), static_cast<float>(one.y));});
    };
  return any(polygon1, polygon2) || any(polygon2, polygon1);
}
