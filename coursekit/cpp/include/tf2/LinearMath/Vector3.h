// Vectors of three numbers.
#pragma once
#include "tf2/LinearMath/Scalar.h"

namespace tf2
{
class Vector3
{
public:
  Vector3() = default;
  Vector3(tf2Scalar x, tf2Scalar y, tf2Scalar z)
  : v_{x, y, z} {}

  const tf2Scalar & x() const {return v_[0];}
  const tf2Scalar & y() const {return v_[1];}
  const tf2Scalar & z() const {return v_[2];}
  const tf2Scalar & getX() const {return v_[0];}
  const tf2Scalar & getY() const {return v_[1];}
  const tf2Scalar & getZ() const {return v_[2];}
  const tf2Scalar & m(int i) const {return v_[i];}
  void setX(tf2Scalar value) {v_[0] = value;}
  void setY(tf2Scalar value) {v_[1] = value;}
  void setZ(tf2Scalar value) {v_[2] = value;}
  void setValue(tf2Scalar x, tf2Scalar y, tf2Scalar z) {*this = Vector3(x, y, z);}
  void setZero() {*this = Vector3(0, 0, 0);}
  bool isZero() const {return v_[0] == 0 && v_[1] == 0 && v_[2] == 0;}
  bool fuzzyZero() const {return length2() < TF2SIMD_EPSILON;}
  tf2Scalar & operator[](int i) {return v_[i];}
  const tf2Scalar & operator[](int i) const {return v_[i];}

  Vector3 operator+(const Vector3 & o) const {return Vector3(v_[0] + o[0], v_[1] + o[1], v_[2] + o[2]);}
  Vector3 operator-(const Vector3 & o) const {return Vector3(v_[0] - o[0], v_[1] - o[1], v_[2] - o[2]);}
  Vector3 operator*(const Vector3 & o) const {return Vector3(v_[0] * o[0], v_[1] * o[1], v_[2] * o[2]);}
  Vector3 operator*(tf2Scalar factor) const {return Vector3(v_[0] * factor, v_[1] * factor, v_[2] * factor);}
  Vector3 operator/(tf2Scalar divisor) const {return *this * (1 / divisor);}
  Vector3 operator/(const Vector3 & o) const {return Vector3(v_[0] / o[0], v_[1] / o[1], v_[2] / o[2]);}
  Vector3 operator-() const {return *this * -1;}
  Vector3 & operator+=(const Vector3 & o) {return *this = *this + o;}
  Vector3 & operator-=(const Vector3 & o) {return *this = *this - o;}
  Vector3 & operator*=(const Vector3 & o) {return *this = *this * o;}
  Vector3 & operator*=(tf2Scalar factor) {return *this = *this * factor;}
  Vector3 & operator/=(tf2Scalar divisor) {return *this = *this / divisor;}
  bool operator==(const Vector3 & o) const {return v_[0] == o[0] && v_[1] == o[1] && v_[2] == o[2];}
  bool operator!=(const Vector3 & o) const {return !(*this == o);}

  tf2Scalar dot(const Vector3 & o) const {return v_[0] * o[0] + v_[1] * o[1] + v_[2] * o[2];}
  Vector3 cross(const Vector3 & o) const
  {
    return Vector3(v_[1] * o[2] - v_[2] * o[1], v_[2] * o[0] - v_[0] * o[2], v_[0] * o[1] - v_[1] * o[0]);
  }
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return std::sqrt(length2());}
  tf2Scalar distance2(const Vector3 & o) const {return (o - *this).length2();}
  tf2Scalar distance(const Vector3 & o) const {return (o - *this).length();}
  tf2Scalar angle(const Vector3 & o) const {return std::acos(dot(o) / std::sqrt(length2() * o.length2()));}
  Vector3 normalized() const {return *this / length();}
  Vector3 & normalize() {return *this = normalized();}
  Vector3 absolute() const {return Vector3(std::fabs(v_[0]), std::fabs(v_[1]), std::fabs(v_[2]));}
  tf2Scalar triple(const Vector3 & a, const Vector3 & b) const {return dot(a.cross(b));}
  /// The axis, 0 to 2, of which it has the least, and the most.
  int minAxis() const {return v_[0] < v_[1] ? (v_[0] < v_[2] ? 0 : 2) : (v_[1] < v_[2] ? 1 : 2);}
  int maxAxis() const {return v_[0] < v_[1] ? (v_[1] < v_[2] ? 2 : 1) : (v_[0] < v_[2] ? 2 : 0);}
  int furthestAxis() const {return absolute().minAxis();}
  int closestAxis() const {return absolute().maxAxis();}
  void setMax(const Vector3 & o)
  {
    *this = Vector3(std::fmax(v_[0], o[0]), std::fmax(v_[1], o[1]), std::fmax(v_[2], o[2]));
  }
  void setMin(const Vector3 & o)
  {
    *this = Vector3(std::fmin(v_[0], o[0]), std::fmin(v_[1], o[1]), std::fmin(v_[2], o[2]));
  }
  void setInterpolate3(const Vector3 & a, const Vector3 & b, tf2Scalar t) {*this = a * (1 - t) + b * t;}
  Vector3 lerp(const Vector3 & o, const tf2Scalar & t) const {return *this + (o - *this) * t;}
  /// This vector after a turn about a unit axis.
  Vector3 rotate(const Vector3 & axis, tf2Scalar angle) const
  {
    Vector3 along = axis * axis.dot(*this);
    return along + (*this - along) * std::cos(angle) + axis.cross(*this) * std::sin(angle);
  }

private:
  tf2Scalar v_[3] = {0, 0, 0};
};
inline Vector3 operator*(tf2Scalar factor, const Vector3 & v) {return v * factor;}
inline tf2Scalar tf2Dot(const Vector3 & a, const Vector3 & b) {return a.dot(b);}
inline tf2Scalar tf2Distance(const Vector3 & a, const Vector3 & b) {return a.distance(b);}
inline Vector3 tf2Cross(const Vector3 & a, const Vector3 & b) {return a.cross(b);}
inline tf2Scalar tf2Distance2(const Vector3 & a, const Vector3 & b) {return a.distance2(b);}
inline tf2Scalar tf2Angle(const Vector3 & a, const Vector3 & b) {return a.angle(b);}
inline tf2Scalar tf2Triple(const Vector3 & a, const Vector3 & b, const Vector3 & c) {return a.triple(b, c);}
inline Vector3 lerp(const Vector3 & a, const Vector3 & b, tf2Scalar t) {return a.lerp(b, t);}
}  // namespace tf2
