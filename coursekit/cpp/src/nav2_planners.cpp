// Planners: planner_server asks, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_core/global_planner.hpp"

namespace nav2_core
{
using coursekit::Packer;
using coursekit::Unpacker;

static void serve(coursekit::Nav2Plugin<GlobalPlanner> & host, Unpacker & from, Packer & to)
{
  const std::string what = from.s();
  if (what != "plan") {
    coursekit::careful(to, [&](Packer &) {host.change(what, from);});
    return;
  }
  coursekit::careful(
    to, [&](Packer & done) {
      host.costmap->renew(from);
      const auto start = from.m<geometry_msgs::msg::PoseStamped>(), goal = from.m<geometry_msgs::msg::PoseStamped>();
      done.m(host.plugin->createPlan(start, goal));
    });
}
}  // namespace nav2_core

coursekit::Handler coursekit::planner_of(const std::string & type)
{
  auto host = std::make_shared<Nav2Plugin<nav2_core::GlobalPlanner>>(type);
  return [host](Unpacker & from, Packer & to) {nav2_core::serve(*host, from, to);};
}
