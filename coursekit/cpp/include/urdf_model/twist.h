// Velocities: along and about three axes.
#pragma once
#include "urdf_model/pose.h"

namespace urdf
{
class Twist
{
public:
  void clear() {*this = Twist();}
  Vector3 linear, angular;
};
}  // namespace urdf
