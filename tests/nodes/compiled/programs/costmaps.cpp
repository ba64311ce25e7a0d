// nav2's names that need no server: costmaps, outlines, lines, paths.
#include <iostream>

#include "nav2_costmap_2d/costmap_layer.hpp"
#include "nav2_costmap_2d/costmap_math.hpp"
#include "nav2_costmap_2d/footprint_collision_checker.hpp"
#include "nav2_util/geometry_utils.hpp"
#include "nav2_util/line_iterator.hpp"
#include "nav2_util/node_utils.hpp"
#include "nav2_util/string_utils.hpp"

using geometry_msgs::msg::Point;
using namespace nav2_costmap_2d;  // NOLINT

Point at(double x, double y)
{
  Point made;
  made.x = x;
  made.y = y;
  return made;
}
void places()
{
  Costmap2D map(4, 3, 0.5, -1.0, 0.0, 7);
  unsigned int x, y;
  std::cout << map.worldToMap(0.9, 1.4, x, y) << " " << x << " " << y << " " << map.worldToMap(1.0, 0.0, x, y)
            << map.worldToMap(-1.1, 0.0, x, y) << std::endl;
  double wx, wy;
  map.mapToWorld(0, 0, wx, wy);
  int ix, iy;
  map.worldToMapEnforceBounds(9.0, -9.0, ix, iy);
  std::cout << wx << " " << wy << " " << map.getIndex(3, 2) << " " << ix << " " << iy << " " << map.getSizeInMetersX() << " "
            << map.cellDistance(1.2) << std::endl;
  map.setCost(1, 0, 9);
  map.updateOrigin(-0.5, 0.0);
  Costmap2D copy(map);
  std::cout << int(copy.getCost(0, 0)) << " " << int(copy.getCost(3, 0)) << " " << copy.getOriginX() << std::endl;
}
void polygons()
{
  Costmap2D map(10, 10, 1.0, 0.0, 0.0);
  std::vector<Point> square{at(1.5, 1.5), at(4.5, 1.5), at(4.5, 4.5), at(1.5, 4.5)};
  const bool drawn = map.setConvexPolygonCost(square, LETHAL_OBSTACLE);
  std::cout << drawn << " " << std::count(map.getCharMap(), map.getCharMap() + 100, LETHAL_OBSTACLE) << " "
            << int(map.getCost(4, 4)) << int(map.getCost(5, 4)) << std::endl;
  Costmap2D part;
  std::cout << part.copyCostmapWindow(map, 4.0, 4.0, 3.0, 2.0) << " " << part.getSizeInCellsX() << " "
            << int(part.getCost(0, 0)) << int(part.getCost(1, 0)) << std::endl;
  FootprintCollisionChecker<Costmap2D *> checker(&map);
  Footprint robot{at(0.4, 0.4), at(0.4, -0.4), at(-0.4, -0.4), at(-0.4, 0.4)};
  std::cout << checker.footprintCostAtPose(7.5, 7.5, 0.0, robot) << " " << checker.footprintCostAtPose(4.5, 3.5, 0.7, robot)
            << " " << checker.footprintCostAtPose(9.9, 5.0, 0.0, robot) << std::endl;
}
void outlines()
{
  std::vector<Point> outline, turned;
  std::cout << makeFootprintFromString("[[0.2, 0.1], [0.2, -0.1], [-0.2, -0.1], [-0.2, 0.1]]", outline)
            << makeFootprintFromString("[[1]]", turned) << makeFootprintFromString("[[1, 2], [3", turned)
            << makeFootprintFromString("[[1, 2], [3, x], [1, 1]]", turned) << std::endl;
  auto radii = calculateMinAndMaxDistances(outline);
  transformFootprint(1.0, 2.0, M_PI / 2, outline, turned);
  std::cout << radii.first << " " << radii.second << " " << turned[0].x << " " << turned[0].y << std::endl;
  padFootprint(outline, 0.01);
  std::cout << outline[2].x << " " << makeFootprintFromRadius(0.3).size() << " " << intersects(outline, 0.1f, 0.05f)
            << intersects(outline, 0.3f, 0.0f) << " " << distanceToLine(1.0, 1.0, 0.0, 0.0, 2.0, 0.0) << std::endl;
}
void lines()
{
  for (nav2_util::LineIterator line(0, 0, 3, -1); line.isValid(); line.advance()) {
    std::cout << line.getX() << "," << line.getY() << " ";
  }
  nav2_util::LineIterator point(5, 5, 5, 5);
  point.advance();
  std::cout << point.isValid() << std::endl;
}
void paths()
{
  nav_msgs::msg::Path path;
  for (double x : {0.0, 1.0, 3.0}) {
    path.poses.emplace_back();
    path.poses.back().pose.position.x = x;
  }
  using namespace nav2_util::geometry_utils;  // NOLINT
  auto after = first_after_integrated_distance(path.poses.begin(), path.poses.end(), 1.5);
  auto never = first_after_integrated_distance(path.poses.begin(), path.poses.end(), 3.5);
  auto least = min_by(
    path.poses.begin(), path.poses.end(), [](auto & one) {return std::abs(one.pose.position.x - 1.2);});
  std::cout << calculate_path_length(path) << " " << calculate_path_length(path, 1) << " " << after->pose.position.x << " "
            << (never == path.poses.end()) << " " << least->pose.position.x << " " << orientationAroundZAxis(M_PI).z << std::endl;
  std::cout << nav2_util::sanitize_node_name("a/b-c") << " " << nav2_util::add_namespaces("a", "b") << " "
            << nav2_util::add_namespaces("/a/", "b") << " " << nav2_util::split("a:b:", ':').size() << " "
            << nav2_util::strip_leading_slash("/a") << " " << nav2_util::time_to_string(4).size() << std::endl;
}
struct Own : CostmapLayer
{
  explicit Own(unsigned char cost)
  {
    resizeMap(4, 1, 1.0, 0.0, 0.0);
    resetMapToValue(0, 0, 3, 1, cost);
    costmap_[3] = NO_INFORMATION;
    enabled_ = true;
  }
  void reset() override {}
  bool isClearable() override {return true;}
  void updateBounds(double, double, double, double *, double *, double *, double *) override {}
  void updateCosts(Costmap2D & master, int x0, int y0, int xn, int yn) override {way(*this, master, x0, y0, xn, yn);}
  void most(Costmap2D & m, int a, int b, int c, int d) {updateWithMax(m, a, b, c, d);}
  void over(Costmap2D & m, int a, int b, int c, int d) {updateWithOverwrite(m, a, b, c, d);}
  void truly(Costmap2D & m, int a, int b, int c, int d) {updateWithTrueOverwrite(m, a, b, c, d);}
  void sum(Costmap2D & m, int a, int b, int c, int d) {updateWithAddition(m, a, b, c, d);}
  std::function<void (Own &, Costmap2D &, int, int, int, int)> way;
};
void layers()
{
  for (auto way : {&Own::most, &Own::over, &Own::truly, &Own::sum}) {
    Costmap2D master(4, 1, 1.0, 0.0, 0.0, 0);
    master.setCost(1, 0, 200);
    master.setCost(2, 0, NO_INFORMATION);
    Own own(100);
    own.way = way;
    own.updateCosts(master, 0, 0, 4, 1);
    for (unsigned int i = 0; i < 4; ++i) {
      std::cout << int(master.getCost(i)) << (i < 3 ? " " : "\n");
    }
  }
  Own own(100);
  own.clearArea(1, 0, 3, 1, false);
  std::cout << int(own.getCost(0)) << " " << int(own.getCost(1)) << " " << own.isCurrent() << std::endl;
}

int main()
{
  places();
  polygons();
  outlines();
  lines();
  paths();
  layers();
}
