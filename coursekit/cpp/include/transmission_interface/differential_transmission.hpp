// Two actuators whose sum moves one joint, and whose difference the other.
#pragma once
#include "transmission_interface/transmission.hpp"

namespace transmission_interface
{
class DifferentialTransmission : public CoursekitPair
{
public:
  using CoursekitPair::CoursekitPair;

protected:
  Numbers to_joints(const std::string & kind, const Numbers & act) const override
  {
    const auto & ar = actuator_reduction_, & jr = joint_reduction_;
    if (is_effort(kind)) {
      double first = act[0] * ar[0], second = act[1] * ar[1];
      return {jr[0] * (first + second), jr[1] * (first - second)};
    }
    double first = act[0] / ar[0], second = act[1] / ar[1];
    return offset(kind, {(first + second) / (2.0 * jr[0]), (first - second) / (2.0 * jr[1])}, 1);
  }
  Numbers to_actuators(const std::string & kind, const Numbers & joints) const override
  {
    const auto & ar = actuator_reduction_, & jr = joint_reduction_;
    if (is_effort(kind)) {
      double first = joints[0] / jr[0], second = joints[1] / jr[1];
      return {(first + second) / (2.0 * ar[0]), (first - second) / (2.0 * ar[1])};
    }
    Numbers from = offset(kind, joints, -1);
    double first = from[0] * jr[0], second = from[1] * jr[1];
    return {(first + second) * ar[0], (first - second) * ar[1]};
  }
};
}  // namespace transmission_interface
