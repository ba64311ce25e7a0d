// The number type of vectors and turns, and its arithmetic under Bullet's names.
#pragma once
#include <algorithm>
#include <cmath>
typedef double tf2Scalar;
#define TF2SIMD_PI 3.141592653589793
#define TF2SIMD_2_PI (2 * TF2SIMD_PI)
#define TF2SIMD_HALF_PI (TF2SIMD_PI / 2)
#define TF2SIMD_RADS_PER_DEG (TF2SIMD_2_PI / 360)
#define TF2SIMD_DEGS_PER_RAD (360 / TF2SIMD_2_PI)
#define TF2SIMDSQRT12 0.7071067811865476
#define TF2SIMD_EPSILON 2.220446049250313e-16
#define TF2SIMD_INFINITY 1.7976931348623157e308
#define tf2RecipSqrt(x) ((tf2Scalar)(1 / tf2Sqrt(tf2Scalar(x))))

inline tf2Scalar tf2Sqrt(tf2Scalar x) {return std::sqrt(x);}
inline tf2Scalar tf2Fabs(tf2Scalar x) {return std::fabs(x);}
inline tf2Scalar tf2Cos(tf2Scalar x) {return std::cos(x);}
inline tf2Scalar tf2Sin(tf2Scalar x) {return std::sin(x);}
inline tf2Scalar tf2Tan(tf2Scalar x) {return std::tan(x);}
inline tf2Scalar tf2Acos(tf2Scalar x) {return std::acos(std::clamp(x, -1.0, 1.0));}
inline tf2Scalar tf2Asin(tf2Scalar x) {return std::asin(std::clamp(x, -1.0, 1.0));}
inline tf2Scalar tf2Atan(tf2Scalar x) {return std::atan(x);}
inline tf2Scalar tf2Atan2(tf2Scalar y, tf2Scalar x) {return std::atan2(y, x);}
inline tf2Scalar tf2Exp(tf2Scalar x) {return std::exp(x);}
inline tf2Scalar tf2Log(tf2Scalar x) {return std::log(x);}
inline tf2Scalar tf2Pow(tf2Scalar x, tf2Scalar y) {return std::pow(x, y);}
inline tf2Scalar tf2Fmod(tf2Scalar x, tf2Scalar y) {return std::fmod(x, y);}
inline tf2Scalar tf2Radians(tf2Scalar degrees) {return degrees * TF2SIMD_RADS_PER_DEG;}
inline tf2Scalar tf2Degrees(tf2Scalar radians) {return radians * TF2SIMD_DEGS_PER_RAD;}
inline bool tf2FuzzyZero(tf2Scalar x) {return std::fabs(x) < TF2SIMD_EPSILON;}
inline bool tf2Equal(tf2Scalar x, tf2Scalar within) {return -within <= x && x <= within;}
inline bool tf2GreaterEqual(tf2Scalar x, tf2Scalar within) {return !(x <= within);}
inline int tf2IsNegative(tf2Scalar x) {return x < 0;}
inline tf2Scalar tf2Fsel(tf2Scalar x, tf2Scalar positive, tf2Scalar negative) {return x >= 0 ? positive : negative;}
/// An angle by whole turns nearer to none.
inline tf2Scalar tf2NormalizeAngle(tf2Scalar angle)
{
  angle = std::fmod(angle, TF2SIMD_2_PI);
  return angle < -TF2SIMD_PI ? angle + TF2SIMD_2_PI : angle > TF2SIMD_PI ? angle - TF2SIMD_2_PI : angle;
}
template<typename T>
void tf2Swap(T & a, T & b)
{
  std::swap(a, b);
}
