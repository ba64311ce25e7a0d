#pragma once
#include <cmath>
typedef double tf2Scalar;
#define TF2SIMD_PI 3.141592653589793
#define TF2SIMD_EPSILON 2.220446049250313e-16
inline tf2Scalar tf2Radians(tf2Scalar degrees) {return degrees * TF2SIMD_PI / 180.0;}
inline tf2Scalar tf2Degrees(tf2Scalar radians) {return radians * 180.0 / TF2SIMD_PI;}
