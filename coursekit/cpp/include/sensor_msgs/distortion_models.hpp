// The names of the ways in which lenses bend a picture.
#pragma once
#include <string>

namespace sensor_msgs::distortion_models
{
const char PLUMB_BOB[] = "plumb_bob";
const char RATIONAL_POLYNOMIAL[] = "rational_polynomial";
const char EQUIDISTANT[] = "equidistant";
}  // namespace sensor_msgs::distortion_models
