// Serving the controller manager.
#include "coursekit/plugins.hpp"
#include "rclcpp/rclcpp.hpp"

namespace coursekit
{
int run_plugins(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  const std::string kind = argc > 1 ? argv[1] : "", type = argc > 2 ? argv[2] : "";
  const int64_t handler = add_handler(kind == "controller" ? controller_of(type) : hardware_of(type));
  request("serve", Packer{}.i(handler));  // until the manager ends
  remove_handler(handler);  // which has the object
  return 0;
}
}  // namespace coursekit
