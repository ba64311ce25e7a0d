// Hardware with several joints.
#pragma once
#include "hardware_interface/coursekit_component.hpp"

namespace hardware_interface
{
class SystemInterface : public HardwareComponent
{
public:
  std::vector<CommandInterface> export_command_interfaces() override = 0;
  return_type write(const rclcpp::Time & time, const rclcpp::Duration & period) override = 0;
};
}  // namespace hardware_interface
