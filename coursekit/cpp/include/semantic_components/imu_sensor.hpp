// The states of an IMU.
#pragma once
#include <array>

#include "semantic_components/semantic_component_interface.hpp"
#include "sensor_msgs/msg/imu.hpp"

namespace semantic_components
{
class IMUSensor : public SemanticComponentInterface<sensor_msgs::msg::Imu>
{
public:
  explicit IMUSensor(const std::string & name)
  : SemanticComponentInterface(name, 10)
  {
    for (auto part : {"orientation.x", "orientation.y", "orientation.z", "orientation.w", "angular_velocity.x",
        "angular_velocity.y", "angular_velocity.z", "linear_acceleration.x", "linear_acceleration.y", "linear_acceleration.z"})
    {
      interface_names_.push_back(name_ + "/" + part);
    }
  }
  std::array<double, 4> get_orientation() {return part<4>(0);}
  std::array<double, 3> get_angular_velocity() {return part<3>(4);}
  std::array<double, 3> get_linear_acceleration() {return part<3>(7);}
  /// Covariances are left as they are.
  bool get_values_as_message(sensor_msgs::msg::Imu & message)
  {
    const auto turned = get_orientation();
    const auto turning = get_angular_velocity(), pushed = get_linear_acceleration();
    message.orientation.x = turned[0];
    message.orientation.y = turned[1];
    message.orientation.z = turned[2];
    message.orientation.w = turned[3];
    message.angular_velocity.x = turning[0];
    message.angular_velocity.y = turning[1];
    message.angular_velocity.z = turning[2];
    message.linear_acceleration.x = pushed[0];
    message.linear_acceleration.y = pushed[1];
    message.linear_acceleration.z = pushed[2];
    return true;
  }

private:
  template<size_t N>
  std::array<double, N> part(size_t begin) const
  {
    std::array<double, N> values;
    for (size_t i = 0; i < N; ++i) {
      values[i] = state_interfaces_.at(begin + i).get().get_value();
    }
    return values;
  }
};
}  // namespace semantic_components
