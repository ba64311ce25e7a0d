// Smoothers: smoother_server asks, their classes do.
#include "coursekit/nav2.hpp"
#include "coursekit/plugins.hpp"
#include "nav2_core/smoother.hpp"

namespace nav2_core
{
using coursekit::Packer;
using coursekit::Unpacker;

namespace
{
struct SmootherHost : coursekit::Nav2Plugin<Smoother>
{
  using Nav2Plugin::Nav2Plugin;
  void configure(Unpacker & from)
  {
    meet_and_listen(from);
    plugin->configure(node, name, buffer, heard_costs, heard_outline);
  }
};
}  // namespace

static void serve(SmootherHost & host, Unpacker & from, Packer & done)
{
  const std::string what = from.s();
  if (what == "smooth") {
    auto path = from.m<nav_msgs::msg::Path>();
    const bool completed = host.plugin->smooth(path, rclcpp::Duration::from_nanoseconds(from.i()));
    done.i(completed).m(path);
  } else if (what == "configure") {
    host.configure(from);
  } else {
    host.change(what);
  }
}
}  // namespace nav2_core

coursekit::Handler coursekit::smoother_of(const std::string & type)
{
  auto host = std::make_shared<nav2_core::SmootherHost>(type);
  return [host](Unpacker & from, Packer & to) {careful(to, [&](Packer & done) {nav2_core::serve(*host, from, done);});};
}
