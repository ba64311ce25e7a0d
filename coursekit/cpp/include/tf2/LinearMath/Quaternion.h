// Quaternions: turns, with x, y, z and w.
#pragma once
#include <algorithm>

#include "tf2/LinearMath/Vector3.h"

namespace tf2
{
class Quaternion
{
public:
  Quaternion() = default;
  Quaternion(tf2Scalar x, tf2Scalar y, tf2Scalar z, tf2Scalar w)
  : x_(x), y_(y), z_(z), w_(w) {}
  Quaternion(const Vector3 & axis, tf2Scalar angle) {setRotation(axis, angle);}

  tf2Scalar x() const {return x_;}
  tf2Scalar y() const {return y_;}
  tf2Scalar z() const {return z_;}
  tf2Scalar w() const {return w_;}
  tf2Scalar getX() const {return x_;}
  tf2Scalar getY() const {return y_;}
  tf2Scalar getZ() const {return z_;}
  tf2Scalar getW() const {return w_;}
  tf2Scalar & operator[](int i) {return i == 0 ? x_ : i == 1 ? y_ : i == 2 ? z_ : w_;}
  const tf2Scalar & operator[](int i) const {return i == 0 ? x_ : i == 1 ? y_ : i == 2 ? z_ : w_;}
  void setX(tf2Scalar value) {x_ = value;}
  void setY(tf2Scalar value) {y_ = value;}
  void setZ(tf2Scalar value) {z_ = value;}
  void setW(tf2Scalar value) {w_ = value;}
  void setValue(tf2Scalar x, tf2Scalar y, tf2Scalar z, tf2Scalar w) {*this = Quaternion(x, y, z, w);}

  void setRotation(const Vector3 & axis, tf2Scalar angle)
  {
    Vector3 part = axis * (std::sin(angle / 2) / axis.length());
    *this = Quaternion(part.x(), part.y(), part.z(), std::cos(angle / 2));
  }
  /// Turn about x by roll, then about y by pitch, then about z by yaw, all axes fixed.
  void setRPY(tf2Scalar roll, tf2Scalar pitch, tf2Scalar yaw)
  {
    *this = Quaternion(Vector3(0, 0, 1), yaw) * Quaternion(Vector3(0, 1, 0), pitch) * Quaternion(Vector3(1, 0, 0), roll);
  }
  /// Turn about y by yaw, then about the turned x by pitch, then about the turned z by roll.
  void setEuler(tf2Scalar yaw, tf2Scalar pitch, tf2Scalar roll)
  {
    *this = Quaternion(Vector3(0, 1, 0), yaw) * Quaternion(Vector3(1, 0, 0), pitch) * Quaternion(Vector3(0, 0, 1), roll);
  }
  void setEulerZYX(tf2Scalar yaw, tf2Scalar pitch, tf2Scalar roll) {setRPY(roll, pitch, yaw);}

  Quaternion operator*(const Quaternion & o) const
  {
    return Quaternion(
      w_ * o.x_ + x_ * o.w_ + y_ * o.z_ - z_ * o.y_, w_ * o.y_ + y_ * o.w_ + z_ * o.x_ - x_ * o.z_,
      w_ * o.z_ + z_ * o.w_ + x_ * o.y_ - y_ * o.x_, w_ * o.w_ - x_ * o.x_ - y_ * o.y_ - z_ * o.z_);
  }
  Quaternion operator*(tf2Scalar f) const {return Quaternion(x_ * f, y_ * f, z_ * f, w_ * f);}
  Quaternion operator/(tf2Scalar d) const {return *this * (1 / d);}
  Quaternion operator+(const Quaternion & o) const {return Quaternion(x_ + o.x_, y_ + o.y_, z_ + o.z_, w_ + o.w_);}
  Quaternion operator-(const Quaternion & o) const {return Quaternion(x_ - o.x_, y_ - o.y_, z_ - o.z_, w_ - o.w_);}
  Quaternion operator-() const {return *this * -1;}
  Quaternion & operator*=(const Quaternion & o) {return *this = *this * o;}
  Quaternion & operator*=(tf2Scalar f) {return *this = *this * f;}
  Quaternion & operator/=(tf2Scalar d) {return *this = *this / d;}
  Quaternion & operator+=(const Quaternion & o) {return *this = *this + o;}
  Quaternion & operator-=(const Quaternion & o) {return *this = *this - o;}
  bool operator==(const Quaternion & o) const {return x_ == o.x_ && y_ == o.y_ && z_ == o.z_ && w_ == o.w_;}
  bool operator!=(const Quaternion & o) const {return !(*this == o);}

  tf2Scalar dot(const Quaternion & o) const {return x_ * o.x_ + y_ * o.y_ + z_ * o.z_ + w_ * o.w_;}
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return std::sqrt(length2());}
  Quaternion normalized() const {return *this / length();}
  Quaternion & normalize() {return *this = normalized();}
  Quaternion inverse() const {return Quaternion(-x_, -y_, -z_, w_);}
  tf2Scalar getAngle() const {return 2 * std::acos(std::clamp(w_, -1.0, 1.0));}
  Vector3 getAxis() const
  {
    tf2Scalar square = 1 - w_ * w_;
    return square < 10 * TF2SIMD_EPSILON ? Vector3(1, 0, 0) : Vector3(x_, y_, z_) / std::sqrt(square);
  }
  /// Half the angle between the two as vectors of four numbers.
  tf2Scalar angle(const Quaternion & o) const {return std::acos(std::clamp(dot(o) / std::sqrt(length2() * o.length2()), -1.0, 1.0));}
  tf2Scalar angleShortestPath(const Quaternion & o) const {return 2 * (dot(o) < 0 ? angle(-o) : angle(o));}
  Quaternion slerp(const Quaternion & o, tf2Scalar t) const
  {
    tf2Scalar theta = dot(o) < 0 ? angle(-o) : angle(o);
    if (theta == 0) {
      return *this;
    }
    Quaternion end = dot(o) < 0 ? -o : o;
    return (*this * std::sin((1 - t) * theta) + end * std::sin(t * theta)) / std::sin(theta);
  }
  tf2Scalar getAngleShortestPath() const {return 2 * std::acos(std::clamp(std::fabs(w_), -1.0, 1.0));}
  /// Of the other and its opposite, which are one turn, the one that is further, and the one that is nearer.
  Quaternion farthest(const Quaternion & o) const {return (*this - o).dot(*this - o) > (*this + o).dot(*this + o) ? o : -o;}
  Quaternion nearest(const Quaternion & o) const {return (*this - o).dot(*this - o) < (*this + o).dot(*this + o) ? o : -o;}
  static const Quaternion & getIdentity()
  {
    static const Quaternion identity(0, 0, 0, 1);
    return identity;
  }

private:
  tf2Scalar x_ = 0, y_ = 0, z_ = 0, w_ = 1;
};
inline Quaternion inverse(const Quaternion & q) {return q.inverse();}
inline tf2Scalar dot(const Quaternion & a, const Quaternion & b) {return a.dot(b);}
inline tf2Scalar length(const Quaternion & q) {return q.length();}
inline tf2Scalar angle(const Quaternion & a, const Quaternion & b) {return a.angle(b);}
inline tf2Scalar angleShortestPath(const Quaternion & a, const Quaternion & b) {return a.angleShortestPath(b);}
inline Quaternion slerp(const Quaternion & a, const Quaternion & b, const tf2Scalar & t) {return a.slerp(b, t);}
inline Vector3 quatRotate(const Quaternion & q, const Vector3 & v)
{
  Quaternion turned = q * Quaternion(v.x(), v.y(), v.z(), 0) * q.inverse();
  return Vector3(turned.x(), turned.y(), turned.z());
}
inline Quaternion operator*(const Quaternion & q, const Vector3 & v) {return q * Quaternion(v.x(), v.y(), v.z(), 0);}
inline Quaternion operator*(const Vector3 & v, const Quaternion & q) {return Quaternion(v.x(), v.y(), v.z(), 0) * q;}
/// The shortest turn from one unit vector to another.
inline Quaternion shortestArcQuat(const Vector3 & from, const Vector3 & to)
{
  tf2Scalar cosine = from.dot(to);
  if (cosine < -1 + TF2SIMD_EPSILON) {  // opposite: half a turn about any axis across
    Vector3 other = std::fabs(from.z()) > 0.7 ? Vector3(1, 0, 0) : Vector3(0, 0, 1);
    return Quaternion(from.cross(other).normalized(), TF2SIMD_PI);
  }
  Vector3 axis = from.cross(to);
  tf2Scalar scale = std::sqrt((1 + cosine) * 2);
  return Quaternion(axis.x() / scale, axis.y() / scale, axis.z() / scale, scale / 2);
}
inline Quaternion shortestArcQuatNormalize2(Vector3 & from, Vector3 & to)
{
  return shortestArcQuat(from.normalize(), to.normalize());
}
}  // namespace tf2
