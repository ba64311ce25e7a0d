// Serving the process that the program is a part of.
#include "coursekit/plugins.hpp"
#include "rclcpp/rclcpp.hpp"

namespace coursekit
{
static Handler handler_of(const std::string & kind, const std::string & type)
{
  static const std::map<std::string, Handler (*)(const std::string &)> known = {
    {"hardware", hardware_of}, {"controller", controller_of}, {"planner", planner_of},
    {"path_controller", path_controller_of}, {"goal_checker", goal_checker_of}, {"progress_checker", progress_checker_of},
    {"layer", layer_of}, {"behavior", behavior_of}, {"waypoint_task", waypoint_task_of},
    {"smoother", smoother_of}, {"tree_nodes", tree_nodes_of}};
  return known.at(kind)(type);
}

int run_plugins(int argc, char ** argv)
{
  rclcpp::detail::init(argc, argv, rclcpp::InitOptions(), rclcpp::SignalHandlerOptions::All);
  const std::string kind = argc > 1 ? argv[1] : "", type = argc > 2 ? argv[2] : "";
  const int64_t handler = add_handler(handler_of(kind, type));
  request("serve", Packer{}.i(handler));  // until the process ends
  remove_handler(handler);  // which has the object
  return 0;
}
}  // namespace coursekit
