// Numbers go through transmissions from actuators to joints and back.
#include <iostream>

#include "hardware_interface/component_parser.hpp"
#include "rclcpp/rclcpp.hpp"
#include "transmission_interface/differential_transmission.hpp"
#include "transmission_interface/four_bar_linkage_transmission.hpp"
#include "transmission_interface/simple_transmission.hpp"
#include "transmission_interface/simple_transmission_loader.hpp"
#include "transmission_interface/transmission_interface_exception.hpp"

using namespace transmission_interface;  // NOLINT
const std::vector<std::string> KINDS{"position", "velocity", "effort"};

// The numbers of one or two joints and actuators: positions, velocities, efforts.
struct Mechanism
{
  explicit Mechanism(std::vector<double> numbers)
  : actuators(std::move(numbers)), joints(actuators.size()), given(actuators)
  {
    size_t size = actuators.size() / KINDS.size();
    for (size_t i = 0; i < actuators.size(); ++i) {
      std::string index(1, static_cast<char>('a' + i % size));
      joint_handles.emplace_back("joint_" + index, KINDS[i / size], &joints[i]);
      actuator_handles.emplace_back("motor_" + index, KINDS[i / size], &actuators[i]);
    }
  }
  void turn(const char * name, Transmission & transmission)
  {
    transmission.configure(joint_handles, actuator_handles);
    transmission.actuator_to_joint();
    std::cout << name;
    for (double one : joints) {std::cout << " " << one;}
    std::fill(actuators.begin(), actuators.end(), 0);
    transmission.joint_to_actuator();
    std::cout << " back";
    for (size_t i = 0; i < actuators.size(); ++i) {
      if (actuators.size() == 3 || i < 2 || i > 3) {std::cout << " " << actuators[i];}
    }
    std::cout << std::endl;
    if (actuators != given) {std::cout << "not as before" << std::endl;}
  }
  std::vector<double> actuators, joints, given;
  std::vector<JointHandle> joint_handles;
  std::vector<ActuatorHandle> actuator_handles;
};

template<class F>
void refused(F what)
{
  try {
    what();
  } catch (const TransmissionInterfaceException & error) {
    std::cout << error.what() << std::endl;
  }
}

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  SimpleTransmission simple(50, 0.25);
  Mechanism({100, 200, 3}).turn("simple", simple);
  DifferentialTransmission differential({10, 20}, {0.5, 2}, {1.5, 0.5});
  Mechanism({20, 40, 20, 30, 2, 3}).turn("differential", differential);
  FourBarLinkageTransmission linkage({8, 10}, {2, 0.5}, {3.5, 1.5});
  Mechanism({40, 10, 80, 25, 2, 3}).turn("linkage", linkage);

  double number = 1;
  std::vector<JointHandle> elbow{{"elbow", "position", &number}}, arm{{"a", "position", &number}, {"b", "position", &number}};
  std::vector<ActuatorHandle> motors{{"a", "position", &number}, {"b", "velocity", &number}}, motor{{"a", "velocity", &number}};
  refused([&] {simple.configure({}, motors);});
  refused([&] {differential.configure(elbow, motors);});
  refused([&] {differential.configure(arm, motors);});
  refused([&] {simple.configure(elbow, motor);});
  refused([] {SimpleTransmission(0);});
  refused([] {DifferentialTransmission({1}, {1, 2});});

  auto info = hardware_interface::parse_control_resources_from_urdf(argv[1]).at(0).transmissions.at(0);
  info.joints[0].offset = 0.25;
  auto loaded = SimpleTransmissionLoader().load(info);
  double position = 150, angle = 0;
  loaded->configure({{"elbow", "position", &angle}}, {{"motor", "position", &position}});
  loaded->actuator_to_joint();
  std::cout << info.name << " " << angle << std::endl;
  info.joints[0].mechanical_reduction = 0;
  std::cout << (SimpleTransmissionLoader().load(info) == nullptr) << std::endl;
}
