// ros2_control's names that need no controller manager.
#include <iostream>
#include <vector>

#include "controller_interface/helpers.hpp"
#include "hardware_interface/component_parser.hpp"
#include "hardware_interface/lexical_casts.hpp"
#include "hardware_interface/loaned_command_interface.hpp"
#include "hardware_interface/types/lifecycle_state_names.hpp"
#include "semantic_components/force_torque_sensor.hpp"
#include "semantic_components/imu_sensor.hpp"
#include "semantic_components/range_sensor.hpp"

namespace hw = hardware_interface;

void loans()
{
  double number = 1.5;
  hw::CommandInterface command("wheel", "velocity", &number);
  {
    hw::LoanedCommandInterface loan(command, [] {std::cout << "given back" << std::endl;});
    hw::LoanedCommandInterface moved(std::move(loan));
    moved.set_value(2.5);
    std::cout << moved.get_name() << " " << moved.get_prefix_name() << " " << moved.get_interface_name() << " " << number << std::endl;
  }
  hw::StateInterface nothing("wheel", "effort");
  std::cout << static_cast<bool>(command) << static_cast<bool>(nothing) << std::endl;
  try {
    nothing.get_value();
  } catch (const std::runtime_error & error) {
    std::cout << std::string(error.what()).substr(std::string(error.what()).find("failed")) << std::endl;
  }
}

void sensors()
{
  std::vector<double> numbers{1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  std::vector<hw::StateInterface> states;
  semantic_components::IMUSensor imu("imu");
  for (size_t i = numbers.size(); i-- > 0; ) {
    states.emplace_back("imu", imu.get_state_interface_names()[i].substr(4), &numbers[i]);
  }
  states.emplace_back("wrist", "torque.z", &numbers[1]);
  std::vector<hw::LoanedStateInterface> loans;
  for (auto & one : states) {
    loans.emplace_back(one);
  }
  sensor_msgs::msg::Imu message;
  std::cout << imu.assign_loaned_state_interfaces(loans) << imu.get_values_as_message(message) << " " << message.orientation.w
            << " " << message.angular_velocity.x << " " << message.linear_acceleration.z << std::endl;
  semantic_components::ForceTorqueSensor wrist("", "", "", "", "", "wrist/torque.z"), missing("ankle");
  std::cout << wrist.assign_loaned_state_interfaces(loans) << missing.assign_loaned_state_interfaces(loans) << " "
            << wrist.get_forces()[0] << " " << wrist.get_torques()[2] << std::endl;
  hw::StateInterface echo("sonar", "range", &numbers[2]);
  std::vector<hw::LoanedStateInterface> heard;
  heard.emplace_back(echo);
  semantic_components::RangeSensor sonar("sonar");
  sensor_msgs::msg::Range far;
  std::cout << sonar.assign_loaned_state_interfaces(heard) << sonar.get_values_as_message(far) << " " << far.range << std::endl;
}

void descriptions(const char * text)
{
  for (auto & one : hw::parse_control_resources_from_urdf(text)) {
    std::cout << one.name << " " << one.type << " " << one.hardware_class_type << " " << one.hardware_parameters.at("port") << " "
              << one.gpios.at(0).command_interfaces.at(0).data_type << " " << one.gpios[0].command_interfaces[0].size << std::endl;
    auto & geared = one.transmissions.at(0);
    std::cout << geared.name << " " << geared.type << " " << geared.joints.at(0).role << " "
              << geared.joints[0].mechanical_reduction << " " << geared.actuators.at(0).name << " " << geared.actuators[0].offset
              << std::endl;
    auto & elbow = geared.joints[0];
    std::cout << elbow.command_interfaces.at(0) << " " << elbow.state_interfaces.at(0) << " " << elbow.state_interfaces.at(1)
              << std::endl;
  }
  try {
    hw::parse_control_resources_from_urdf("<robot name='r'>");
  } catch (const std::runtime_error &) {
    std::cout << "no description" << std::endl;
  }
}

int main(int, char ** argv)
{
  loans();
  sensors();
  descriptions(argv[1]);
  std::cout << hw::stod("0.5") << hw::parse_bool("True") << hw::parse_bool("yes") << hw::lifecycle_state_names::ACTIVE
            << controller_interface::interface_list_contains_interface_type({"position"}, "effort") << std::endl;
  try {
    hw::stod("0,5");
  } catch (const std::invalid_argument & error) {
    std::cout << error.what() << std::endl;
  }
}
