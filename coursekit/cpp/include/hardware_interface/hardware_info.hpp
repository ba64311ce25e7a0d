// What the <ros2_control> of a robot's description says of a piece of hardware.
#pragma once
#include <string>
#include <unordered_map>
#include <vector>

namespace hardware_interface
{
struct InterfaceInfo
{
  std::string name, min, max, initial_value, data_type;
  int size;
};
/// A joint, sensor or gpio.
struct ComponentInfo
{
  std::string name, type;
  std::vector<InterfaceInfo> command_interfaces, state_interfaces;
  std::unordered_map<std::string, std::string> parameters;
};
/// A joint of a transmission.
struct JointInfo
{
  std::string name;
  std::vector<std::string> state_interfaces, command_interfaces;
  std::string role;
  double mechanical_reduction = 1.0;
  double offset = 0.0;
};
/// An actuator of a transmission.
struct ActuatorInfo
{
  std::string name;
  std::vector<std::string> state_interfaces, command_interfaces;
  std::string role;
  double mechanical_reduction = 1.0;
  double offset = 0.0;
};
struct TransmissionInfo
{
  std::string name, type;
  std::vector<JointInfo> joints;
  std::vector<ActuatorInfo> actuators;
  std::unordered_map<std::string, std::string> parameters;
};
struct HardwareInfo
{
  std::string name, type, hardware_class_type;
  std::unordered_map<std::string, std::string> hardware_parameters;
  std::vector<ComponentInfo> joints, sensors, gpios;
  std::vector<TransmissionInfo> transmissions;
  /// The whole description.
  std::string original_xml;
};
}  // namespace hardware_interface
