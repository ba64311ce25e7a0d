// Planners: planner_server asks, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_core/global_planner.hpp"

namespace nav2_core
{
using coursekit::Packer;
using coursekit::Unpacker;

static void serve(coursekit::Nav2Plugin<GlobalPlanner> & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "plan") {
    host.costmap->renew(from);
    const auto start = from.m<geometry_msgs::msg::PoseStamped>(), goal = from.m<geometry_msgs::msg::PoseStamped>();
    done.m(host.plugin->createPlan(start, goal));
  } else if (what == "configure") {
    host.configure(from);
  } else {
    host.change(what);
  }
}
}  // namespace nav2_core

coursekit::Handler coursekit::planner_of(const std::string & type)
{
  auto host = std::make_shared<Nav2Plugin<nav2_core::GlobalPlanner>>(type);
  return [host](Unpacker & from, Packer & to) {careful(to, [&](Packer & done) {nav2_core::serve(*host, from, done);});};
}
