// Vectors of three numbers.
#pragma once
#include <algorithm>

#include "tf2/LinearMath/Data.h"
#include "tf2/LinearMath/MinMax.h"
#include "tf2/LinearMath/Scalar.h"

namespace tf2
{
class Vector3
{
public:
  Vector3() = default;
  Vector3(tf2Scalar x, tf2Scalar y, tf2Scalar z)
  : m_floats{x, y, z, 0} {}

  const tf2Scalar & x() const {return m_floats[0];}
  const tf2Scalar & y() const {return m_floats[1];}
  const tf2Scalar & z() const {return m_floats[2];}
  const tf2Scalar & w() const {return m_floats[3];}
  const tf2Scalar & getX() const {return m_floats[0];}
  const tf2Scalar & getY() const {return m_floats[1];}
  const tf2Scalar & getZ() const {return m_floats[2];}
  const tf2Scalar & m(int i) const {return m_floats[i];}
  void setX(tf2Scalar value) {m_floats[0] = value;}
  void setY(tf2Scalar value) {m_floats[1] = value;}
  void setZ(tf2Scalar value) {m_floats[2] = value;}
  void setW(tf2Scalar value) {m_floats[3] = value;}
  void setValue(tf2Scalar x, tf2Scalar y, tf2Scalar z) {*this = Vector3(x, y, z);}
  void setZero() {*this = Vector3(0, 0, 0);}
  bool isZero() const {return m_floats[0] == 0 && m_floats[1] == 0 && m_floats[2] == 0;}
  bool fuzzyZero() const {return length2() < TF2SIMD_EPSILON;}
  tf2Scalar & operator[](int i) {return m_floats[i];}
  const tf2Scalar & operator[](int i) const {return m_floats[i];}

  Vector3 operator+(const Vector3 & o) const {return Vector3(m_floats[0] + o[0], m_floats[1] + o[1], m_floats[2] + o[2]);}
  Vector3 operator-(const Vector3 & o) const {return Vector3(m_floats[0] - o[0], m_floats[1] - o[1], m_floats[2] - o[2]);}
  Vector3 operator*(const Vector3 & o) const {return Vector3(m_floats[0] * o[0], m_floats[1] * o[1], m_floats[2] * o[2]);}
  Vector3 operator*(tf2Scalar factor) const {return Vector3(m_floats[0] * factor, m_floats[1] * factor, m_floats[2] * factor);}
  Vector3 operator/(tf2Scalar divisor) const {return *this * (1 / divisor);}
  Vector3 operator/(const Vector3 & o) const {return Vector3(m_floats[0] / o[0], m_floats[1] / o[1], m_floats[2] / o[2]);}
  Vector3 operator-() const {return *this * -1;}
  Vector3 & operator+=(const Vector3 & o) {return *this = *this + o;}
  Vector3 & operator-=(const Vector3 & o) {return *this = *this - o;}
  Vector3 & operator*=(const Vector3 & o) {return *this = *this * o;}
  Vector3 & operator*=(tf2Scalar factor) {return *this = *this * factor;}
  Vector3 & operator/=(tf2Scalar divisor) {return *this = *this / divisor;}
  bool operator==(const Vector3 & o) const {return m_floats[0] == o[0] && m_floats[1] == o[1] && m_floats[2] == o[2];}
  bool operator!=(const Vector3 & o) const {return !(*this == o);}

  tf2Scalar dot(const Vector3 & o) const {return m_floats[0] * o[0] + m_floats[1] * o[1] + m_floats[2] * o[2];}
  Vector3 cross(const Vector3 & o) const
  {
    return Vector3(m_floats[1] * o[2] - m_floats[2] * o[1], m_floats[2] * o[0] - m_floats[0] * o[2], m_floats[0] * o[1] - m_floats[1] * o[0]);
  }
  tf2Scalar length2() const {return dot(*this);}
  tf2Scalar length() const {return std::sqrt(length2());}
  tf2Scalar distance2(const Vector3 & o) const {return (o - *this).length2();}
  tf2Scalar distance(const Vector3 & o) const {return (o - *this).length();}
  tf2Scalar angle(const Vector3 & o) const {return std::acos(dot(o) / std::sqrt(length2() * o.length2()));}
  Vector3 normalized() const {return *this / length();}
  Vector3 & normalize() {return *this = normalized();}
  Vector3 absolute() const {return Vector3(std::fabs(m_floats[0]), std::fabs(m_floats[1]), std::fabs(m_floats[2]));}
  tf2Scalar triple(const Vector3 & a, const Vector3 & b) const {return dot(a.cross(b));}
  /// The axis, 0 to 2, of which it has the least, and the most.
  int minAxis() const {return m_floats[0] < m_floats[1] ? (m_floats[0] < m_floats[2] ? 0 : 2) : (m_floats[1] < m_floats[2] ? 1 : 2);}
  int maxAxis() const {return m_floats[0] < m_floats[1] ? (m_floats[1] < m_floats[2] ? 2 : 1) : (m_floats[0] < m_floats[2] ? 2 : 0);}
  int furthestAxis() const {return absolute().minAxis();}
  int closestAxis() const {return absolute().maxAxis();}
  void setMax(const Vector3 & o)
  {
    *this = Vector3(std::fmax(m_floats[0], o[0]), std::fmax(m_floats[1], o[1]), std::fmax(m_floats[2], o[2]));
  }
  void setMin(const Vector3 & o)
  {
    *this = Vector3(std::fmin(m_floats[0], o[0]), std::fmin(m_floats[1], o[1]), std::fmin(m_floats[2], o[2]));
  }
  void setInterpolate3(const Vector3 & a, const Vector3 & b, tf2Scalar t) {*this = a * (1 - t) + b * t;}
  Vector3 lerp(const Vector3 & o, const tf2Scalar & t) const {return *this + (o - *this) * t;}
  /// This vector after a turn about a unit axis.
  Vector3 rotate(const Vector3 & axis, tf2Scalar angle) const
  {
    Vector3 along = axis * axis.dot(*this);
    return along + (*this - along) * std::cos(angle) + axis.cross(*this) * std::sin(angle);
  }
  /// The rows of the matrix that takes a vector to its cross product with this one.
  void getSkewSymmetricMatrix(Vector3 * x, Vector3 * y, Vector3 * z) const
  {
    *x = Vector3(0, -m_floats[2], m_floats[1]);
    *y = Vector3(m_floats[2], 0, -m_floats[0]);
    *z = Vector3(-m_floats[1], m_floats[0], 0);
  }
  void serialize(Vector3Data & data) const {std::copy_n(m_floats, 4, data.m_floats);}
  void serializeDouble(Vector3DoubleData & data) const {serialize(data);}
  void serializeFloat(Vector3FloatData & data) const
  {
    std::transform(m_floats, m_floats + 4, data.m_floats, [](tf2Scalar one) {return static_cast<float>(one);});
  }
  void deSerialize(const Vector3Data & data) {std::copy_n(data.m_floats, 4, m_floats);}
  void deSerializeDouble(const Vector3DoubleData & data) {deSerialize(data);}
  void deSerializeFloat(const Vector3FloatData & data) {std::copy_n(data.m_floats, 4, m_floats);}

  /// Its three numbers, and one more that fills it up.
  tf2Scalar m_floats[4] = {0, 0, 0, 0};
};
inline Vector3 operator*(tf2Scalar factor, const Vector3 & v) {return v * factor;}
inline tf2Scalar tf2Dot(const Vector3 & a, const Vector3 & b) {return a.dot(b);}
inline tf2Scalar tf2Distance(const Vector3 & a, const Vector3 & b) {return a.distance(b);}
inline Vector3 tf2Cross(const Vector3 & a, const Vector3 & b) {return a.cross(b);}
inline tf2Scalar tf2Distance2(const Vector3 & a, const Vector3 & b) {return a.distance2(b);}
inline tf2Scalar tf2Angle(const Vector3 & a, const Vector3 & b) {return a.angle(b);}
inline tf2Scalar tf2Triple(const Vector3 & a, const Vector3 & b, const Vector3 & c) {return a.triple(b, c);}
inline Vector3 lerp(const Vector3 & a, const Vector3 & b, tf2Scalar t) {return a.lerp(b, t);}

/// A vector of four numbers.
class Vector4 : public Vector3
{
public:
  Vector4() = default;
  Vector4(tf2Scalar x, tf2Scalar y, tf2Scalar z, tf2Scalar w)
  : Vector3(x, y, z) {m_floats[3] = w;}
  tf2Scalar getW() const {return m_floats[3];}
  using Vector3::setValue;
  void setValue(tf2Scalar x, tf2Scalar y, tf2Scalar z, tf2Scalar w) {*this = Vector4(x, y, z, w);}
  Vector4 absolute4() const
  {
    return Vector4(std::fabs(m_floats[0]), std::fabs(m_floats[1]), std::fabs(m_floats[2]), std::fabs(m_floats[3]));
  }
  /// The axis, 0 to 3, of which it has the least, and the most.
  int minAxis4() const {return static_cast<int>(std::min_element(m_floats, m_floats + 4) - m_floats);}
  int maxAxis4() const {return static_cast<int>(std::max_element(m_floats, m_floats + 4) - m_floats);}
  int closestAxis4() const {return absolute4().maxAxis4();}
};
/// Two unit vectors across a third, and across each other.
inline void tf2PlaneSpace1(const Vector3 & n, Vector3 & p, Vector3 & q)
{
  bool steep = std::fabs(n.z()) > TF2SIMDSQRT12;
  p = (steep ? Vector3(0, -n.z(), n.y()) : Vector3(-n.y(), n.x(), 0)).normalized();
  q = n.cross(p);
}
}  // namespace tf2
