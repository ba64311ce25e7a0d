// Where something is: a position [m] and a rotation, as a quaternion.
#pragma once
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "urdf_exception/exception.h"

namespace urdf
{
class Vector3
{
public:
  double x = 0, y = 0, z = 0;
  Vector3() = default;
  Vector3(double x_, double y_, double z_)
  : x(x_), y(y_), z(z_) {}
  void clear() {*this = Vector3();}
  /// From three numbers between spaces. Throws ParseError.
  void init(const std::string & text)
  {
    std::istringstream words(text);
    words.imbue(std::locale::classic());
    std::vector<double> numbers;
    for (double number; words >> number; ) {
      numbers.push_back(number);
    }
    if (!words.eof()) {
      throw ParseError("Unable to parse component [" + text + "] to a double (while parsing a vector value)");
    }
    if (numbers.size() != 3) {
      throw ParseError(
              "Parser found " + std::to_string(numbers.size()) + " elements but 3 expected while parsing vector [" + text + "]");
    }
    *this = Vector3(numbers[0], numbers[1], numbers[2]);
  }
  Vector3 operator+(Vector3 o) const {return {x + o.x, y + o.y, z + o.z};}
};

class Rotation
{
public:
  double x = 0, y = 0, z = 0, w = 1;
  Rotation() = default;
  Rotation(double x_, double y_, double z_, double w_)
  : x(x_), y(y_), z(z_), w(w_) {}
  void clear() {*this = Rotation();}
  void init(const std::string & text)
  {
    Vector3 rpy;
    rpy.init(text);
    setFromRPY(rpy.x, rpy.y, rpy.z);
  }
  void getQuaternion(double & qx, double & qy, double & qz, double & qw) const
  {
    qx = x;
    qy = y;
    qz = z;
    qw = w;
  }
  void setFromQuaternion(double qx, double qy, double qz, double qw)
  {
    *this = Rotation(qx, qy, qz, qw);
    normalize();
  }
  /// Angles about the fixed axes x, y, z [rad]; looking straight up or down, the roll is called 0.
  void getRPY(double & roll, double & pitch, double & yaw) const
  {
    const double up = 2 * (w * y - x * z);
    if (std::abs(up) >= 0.99999) {
      const double side = up > 0 ? 1 : -1;
      pitch = side * std::acos(0.0);
      roll = 0;
      yaw = 2 * std::atan2(-side * x, side * y);
      return;
    }
    pitch = std::asin(up);
    roll = std::atan2(2 * (y * z + w * x), w * w - x * x - y * y + z * z);
    yaw = std::atan2(2 * (x * y + w * z), w * w + x * x - y * y - z * z);
  }
  void setFromRPY(double roll, double pitch, double yaw)
  {
    const double cr = std::cos(roll / 2), cp = std::cos(pitch / 2), cy = std::cos(yaw / 2);
    const double sr = std::sin(roll / 2), sp = std::sin(pitch / 2), sy = std::sin(yaw / 2);
    setFromQuaternion(
      sr * cp * cy - cr * sp * sy, cr * sp * cy + sr * cp * sy, cr * cp * sy - sr * sp * cy, cr * cp * cy + sr * sp * sy);
  }
  void normalize()
  {
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    *this = length > 0 ? Rotation(x / length, y / length, z / length, w / length) : Rotation();
  }
  Rotation operator*(const Rotation & o) const
  {
    return {
      w * o.x + x * o.w + y * o.z - z * o.y, w * o.y - x * o.z + y * o.w + z * o.x,
      w * o.z + x * o.y - y * o.x + z * o.w, w * o.w - x * o.x - y * o.y - z * o.z};
  }
  Vector3 operator*(Vector3 v) const
  {
    Rotation turned = *this * (Rotation(v.x, v.y, v.z, 0) * GetInverse());
    return {turned.x, turned.y, turned.z};
  }
  Rotation GetInverse() const
  {
    const double square = x * x + y * y + z * z + w * w;
    return square > 0 ? Rotation(-x / square, -y / square, -z / square, w / square) : Rotation();
  }
};

class Pose
{
public:
  Vector3 position;
  Rotation rotation;
  void clear() {*this = Pose();}
};
}  // namespace urdf
