// Two actuators, of which the first, by a linkage, also moves the second's joint.
#pragma once
#include "transmission_interface/transmission.hpp"

namespace transmission_interface
{
class FourBarLinkageTransmission : public CoursekitPair
{
public:
  using CoursekitPair::CoursekitPair;

protected:
  Numbers to_joints(const std::string & kind, const Numbers & act) const override
  {
    const auto & ar = actuator_reduction_, & jr = joint_reduction_;
    if (is_effort(kind)) {
      double first = jr[0] * act[0] * ar[0];
      return {first, jr[1] * (act[1] * ar[1] - first)};
    }
    double first = act[0] / (jr[0] * ar[0]);
    return offset(kind, {first, (act[1] / ar[1] - first) / jr[1]}, 1);
  }
  Numbers to_actuators(const std::string & kind, const Numbers & joints) const override
  {
    const auto & ar = actuator_reduction_, & jr = joint_reduction_;
    if (is_effort(kind)) {
      return {joints[0] / (ar[0] * jr[0]), (joints[0] + joints[1] / jr[1]) / ar[1]};
    }
    Numbers from = offset(kind, joints, -1);
    return {from[0] * jr[0] * ar[0], (from[0] + from[1] * jr[1]) * ar[1]};
  }
};
}  // namespace transmission_interface
