// Yaw of what turns.
#pragma once
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2
{
inline Quaternion toQuaternion(const Quaternion & q) {return q;}
inline Quaternion toQuaternion(const geometry_msgs::msg::Quaternion & q) {return Quaternion(q.x, q.y, q.z, q.w);}
inline Quaternion toQuaternion(const geometry_msgs::msg::QuaternionStamped & q) {return toQuaternion(q.quaternion);}

template<class A>
void getEulerYPR(const A & turn, double & yaw, double & pitch, double & roll)
{
  Matrix3x3(toQuaternion(turn)).getEulerYPR(yaw, pitch, roll);
}
/// What moves nothing.
template<class A>
A getTransformIdentity()
{
  A identity;
  identity.setIdentity();
  return identity;
}
template<class A>
double getYaw(const A & turn)
{
  double yaw, pitch, roll;
  getEulerYPR(turn, yaw, pitch, roll);
  return yaw;
}
}  // namespace tf2
