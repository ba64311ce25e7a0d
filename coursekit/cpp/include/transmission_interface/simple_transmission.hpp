// A gear or a belt between one actuator and one joint.
#pragma once
#include "transmission_interface/transmission.hpp"

namespace transmission_interface
{
class SimpleTransmission : public CoursekitTransmission<1>
{
public:
  explicit SimpleTransmission(double joint_reduction, double joint_offset = 0.0)
  : reduction_(joint_reduction), jnt_offset_(joint_offset)
  {
    if (reduction_ == 0.0) {
      throw Exception("Transmission reduction ratio cannot be zero.");
    }
  }
  double get_actuator_reduction() const {return reduction_;}
  double get_joint_offset() const {return jnt_offset_;}

protected:
  Numbers to_joints(const std::string & kind, const Numbers & actuators) const override
  {
    if (is_effort(kind)) {
      return {actuators[0] * reduction_};
    }
    return {actuators[0] / reduction_ + (is_position(kind) ? jnt_offset_ : 0.0)};
  }
  Numbers to_actuators(const std::string & kind, const Numbers & joints) const override
  {
    if (is_effort(kind)) {
      return {joints[0] / reduction_};
    }
    return {(joints[0] - (is_position(kind) ? jnt_offset_ : 0.0)) * reduction_};
  }
  double reduction_, jnt_offset_;
};
}  // namespace transmission_interface
