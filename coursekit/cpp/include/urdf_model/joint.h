// Joints: how one link hangs on another. Lengths in metres, angles in radians.
#pragma once
#include <string>

#include "urdf_model/pose.h"
#include "urdf_model/types.h"

namespace urdf
{
class JointDynamics
{
public:
  double damping = 0, friction = 0;
  void clear() {*this = JointDynamics();}
};

class JointLimits
{
public:
  double lower = 0, upper = 0, effort = 0, velocity = 0;
  void clear() {*this = JointLimits();}
};

class JointSafety
{
public:
  double soft_upper_limit = 0, soft_lower_limit = 0, k_position = 0, k_velocity = 0;
  void clear() {*this = JointSafety();}
};

class JointCalibration
{
public:
  double reference_position = 0;
  DoubleSharedPtr rising, falling;
  void clear() {*this = JointCalibration();}
};

/// The position of a joint is that of another, times the multiplier, plus the offset.
class JointMimic
{
public:
  double offset = 0, multiplier = 0;
  std::string joint_name;
  void clear() {*this = JointMimic();}
};

class Joint
{
public:
  enum {UNKNOWN, REVOLUTE, CONTINUOUS, PRISMATIC, FLOATING, PLANAR, FIXED} type = UNKNOWN;
  std::string name;
  Vector3 axis;
  std::string child_link_name, parent_link_name;
  Pose parent_to_joint_origin_transform;
  JointDynamicsSharedPtr dynamics;
  JointLimitsSharedPtr limits;
  JointSafetySharedPtr safety;
  JointCalibrationSharedPtr calibration;
  JointMimicSharedPtr mimic;
  void clear() {*this = Joint();}
};
}  // namespace urdf
