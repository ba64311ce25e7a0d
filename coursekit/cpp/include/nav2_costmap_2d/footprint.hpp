// The outline of the robot.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "geometry_msgs/msg/point.hpp"
#include "geometry_msgs/msg/point32.hpp"
#include "geometry_msgs/msg/polygon.hpp"
#include "geometry_msgs/msg/polygon_stamped.hpp"

namespace nav2_costmap_2d
{
/// The radii of the greatest circle in a footprint and of the least around it, both about the robot's centre.
std::pair<double, double> calculateMinAndMaxDistances(const std::vector<geometry_msgs::msg::Point> & footprint);
geometry_msgs::msg::Point toPoint(geometry_msgs::msg::Point32 pt);
geometry_msgs::msg::Point32 toPoint32(geometry_msgs::msg::Point pt);
geometry_msgs::msg::Polygon toPolygon(std::vector<geometry_msgs::msg::Point> pts);
std::vector<geometry_msgs::msg::Point> toPointVector(geometry_msgs::msg::Polygon::SharedPtr polygon);
void transformFootprint(
  double x, double y, double theta, const std::vector<geometry_msgs::msg::Point> & footprint_spec,
  std::vector<geometry_msgs::msg::Point> & oriented_footprint);
void transformFootprint(
  double x, double y, double theta, const std::vector<geometry_msgs::msg::Point> & footprint_spec,
  geometry_msgs::msg::PolygonStamped & oriented_footprint);
/// Make it larger on all sides.
void padFootprint(std::vector<geometry_msgs::msg::Point> & footprint, double padding);
/// A circle, as a polygon with 16 corners.
std::vector<geometry_msgs::msg::Point> makeFootprintFromRadius(double radius);
/// Read [[x, y], [x, y], ...]; false where it is something else.
bool makeFootprintFromString(const std::string & footprint_string, std::vector<geometry_msgs::msg::Point> & footprint);
}  // namespace nav2_costmap_2d
