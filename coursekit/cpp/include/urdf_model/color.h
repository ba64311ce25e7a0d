// A colour: red, green, blue and how opaque it is, from 0 to 1.
#pragma once

namespace urdf
{
class Color
{
public:
  float r = 0, g = 0, b = 0, a = 1;
  Color() = default;
  Color(float r_, float g_, float b_, float a_)
  : r(r_), g(g_), b(b_), a(a_) {}
  void clear() {*this = Color();}
};
}  // namespace urdf
