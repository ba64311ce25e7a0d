// Transforms: a turn, then a shift.
#pragma once
#include "tf2/LinearMath/Matrix3x3.h"

namespace tf2
{
class Transform
{
public:
  Transform() = default;
  explicit Transform(const Quaternion & turn, const Vector3 & shift = Vector3())
  : basis_(turn), origin_(shift) {}
  explicit Transform(const Matrix3x3 & turn, const Vector3 & shift = Vector3())
  : basis_(turn), origin_(shift) {}

  Matrix3x3 & getBasis() {return basis_;}
  const Matrix3x3 & getBasis() const {return basis_;}
  Vector3 & getOrigin() {return origin_;}
  const Vector3 & getOrigin() const {return origin_;}
  Quaternion getRotation() const
  {
    Quaternion q;
    basis_.getRotation(q);
    return q;
  }
  void setBasis(const Matrix3x3 & turn) {basis_ = turn;}
  void setOrigin(const Vector3 & shift) {origin_ = shift;}
  void setRotation(const Quaternion & turn) {basis_.setRotation(turn);}
  void setIdentity() {*this = Transform();}
  /// From OpenGL's sixteen numbers, column by column.
  void setFromOpenGLMatrix(const tf2Scalar * m)
  {
    basis_.setFromOpenGLSubMatrix(m);
    origin_ = Vector3(m[12], m[13], m[14]);
  }
  void getOpenGLMatrix(tf2Scalar * m) const
  {
    basis_.getOpenGLSubMatrix(m);
    m[12] = origin_.x();
    m[13] = origin_.y();
    m[14] = origin_.z();
    m[15] = 1;
  }
  void mult(const Transform & a, const Transform & b) {*this = a * b;}
  Vector3 invXform(const Vector3 & v) const {return basis_.transpose() * (v - origin_);}
  static const Transform & getIdentity()
  {
    static const Transform identity;
    return identity;
  }
  void serialize(TransformData & data) const
  {
    basis_.serialize(data.m_basis);
    origin_.serialize(data.m_origin);
  }
  void serializeFloat(TransformFloatData & data) const
  {
    basis_.serializeFloat(data.m_basis);
    origin_.serializeFloat(data.m_origin);
  }
  void deSerialize(const TransformData & data)
  {
    basis_.deSerialize(data.m_basis);
    origin_.deSerialize(data.m_origin);
  }
  void deSerializeDouble(const TransformDoubleData & data) {deSerialize(data);}
  void deSerializeFloat(const TransformFloatData & data)
  {
    basis_.deSerializeFloat(data.m_basis);
    origin_.deSerializeFloat(data.m_origin);
  }

  Transform inverse() const
  {
    Matrix3x3 back = basis_.transpose();
    return Transform(back, back * -origin_);
  }
  Transform inverseTimes(const Transform & o) const {return inverse() * o;}
  Vector3 operator()(const Vector3 & v) const {return basis_ * v + origin_;}
  Vector3 operator*(const Vector3 & v) const {return basis_ * v + origin_;}
  Quaternion operator*(const Quaternion & q) const {return getRotation() * q;}
  Transform operator*(const Transform & o) const {return Transform(basis_ * o.basis_, *this * o.origin_);}
  Transform & operator*=(const Transform & o) {return *this = *this * o;}
  bool operator==(const Transform & o) const {return basis_ == o.basis_ && origin_ == o.origin_;}

private:
  Matrix3x3 basis_;
  Vector3 origin_;
};
}  // namespace tf2
