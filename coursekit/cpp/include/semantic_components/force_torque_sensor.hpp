// The states of a sensor of forces and torques.
#pragma once
#include <algorithm>
#include <array>
#include <limits>

#include "geometry_msgs/msg/wrench.hpp"
#include "semantic_components/semantic_component_interface.hpp"

namespace semantic_components
{
/// Axes without a state are nan.
class ForceTorqueSensor : public SemanticComponentInterface<geometry_msgs::msg::Wrench>
{
public:
  explicit ForceTorqueSensor(const std::string & name)
  : SemanticComponentInterface(name, 6)
  {
    for (auto part : {"force.x", "force.y", "force.z", "torque.x", "torque.y", "torque.z"}) {
      add(name_ + "/" + part);
    }
  }
  /// With whole names of the states, empty for those that it lacks.
  ForceTorqueSensor(
    const std::string & force_x, const std::string & force_y, const std::string & force_z,
    const std::string & torque_x, const std::string & torque_y, const std::string & torque_z)
  : SemanticComponentInterface("", 6)
  {
    for (auto & name : {force_x, force_y, force_z, torque_x, torque_y, torque_z}) {
      add(name);
    }
  }
  std::array<double, 3> get_forces() {return values(0);}
  std::array<double, 3> get_torques() {return values(3);}
  bool get_values_as_message(geometry_msgs::msg::Wrench & message)
  {
    const auto forces = get_forces(), torques = get_torques();
    message.force.x = forces[0];
    message.force.y = forces[1];
    message.force.z = forces[2];
    message.torque.x = torques[0];
    message.torque.y = torques[1];
    message.torque.z = torques[2];
    return true;
  }

private:
  void add(const std::string & name)
  {
    has_.push_back(!name.empty());
    if (!name.empty()) {
      interface_names_.push_back(name);
    }
  }
  std::array<double, 3> values(size_t begin) const
  {
    std::array<double, 3> all;
    for (size_t i = 0; i < 3; ++i) {
      const auto at = std::count(has_.begin(), has_.begin() + static_cast<std::ptrdiff_t>(begin + i), true);
      all[i] = has_[begin + i] ? state_interfaces_.at(static_cast<size_t>(at)).get().get_value() :
        std::numeric_limits<double>::quiet_NaN();
    }
    return all;
  }
  std::vector<bool> has_;
};
}  // namespace semantic_components
