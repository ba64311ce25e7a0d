// Vectors, matrices and transforms as plain numbers, for files and memory of others.
#pragma once

namespace tf2
{
template<class Number>
struct Vector3Numbers
{
  Number m_floats[4];
};
template<class Number>
struct Matrix3x3Numbers
{
  Vector3Numbers<Number> m_el[3];
};
template<class Number>
struct TransformNumbers
{
  Matrix3x3Numbers<Number> m_basis;
  Vector3Numbers<Number> m_origin;
};
using Vector3FloatData = Vector3Numbers<float>;
using Vector3DoubleData = Vector3Numbers<double>;
using Vector3Data = Vector3DoubleData;
using Matrix3x3FloatData = Matrix3x3Numbers<float>;
using Matrix3x3DoubleData = Matrix3x3Numbers<double>;
using Matrix3x3Data = Matrix3x3DoubleData;
using TransformFloatData = TransformNumbers<float>;
using TransformDoubleData = TransformNumbers<double>;
using TransformData = TransformDoubleData;
}  // namespace tf2
