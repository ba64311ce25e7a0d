// The hardware in a robot's description, which the session parses.
#pragma once
#include <string>
#include <vector>

#include "hardware_interface/hardware_info.hpp"

namespace hardware_interface
{
/// Throws std::runtime_error for what is no description, or has no <ros2_control>.
std::vector<HardwareInfo> parse_control_resources_from_urdf(const std::string & urdf);
}  // namespace hardware_interface
