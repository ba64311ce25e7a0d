// Points, sizes, rectangles, colours: OpenCV's small types.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "opencv2/core/vec.hpp"

#define CV_PI 3.1415926535897932384626433832795

namespace cv
{
using String = std::string;

template<class T>
struct Size_
{
  using value_type = T;
  T width = 0, height = 0;
  Size_() = default;
  Size_(T width_, T height_)
  : width(width_), height(height_) {}
  template<class U>
  operator Size_<U>() const {return {static_cast<U>(width), static_cast<U>(height)};}
  T area() const {return width * height;}
  bool empty() const {return width <= 0 || height <= 0;}
  bool operator==(const Size_ & o) const {return width == o.width && height == o.height;}
  bool operator!=(const Size_ & o) const {return !(*this == o);}
  Size_ operator*(T by) const {return {width * by, height * by};}
  Size_ operator/(T by) const {return {width / by, height / by};}
};

template<class T>
struct Point_
{
  using value_type = T;
  T x = 0, y = 0;
  Point_() = default;
  Point_(T x_, T y_)
  : x(x_), y(y_) {}
  Point_(const Size_<T> & size)  // NOLINT: as OpenCV's
  : x(size.width), y(size.height) {}
  template<class U>
  operator Point_<U>() const {return {saturate_cast<U>(x), saturate_cast<U>(y)};}
  T dot(const Point_ & o) const {return x * o.x + y * o.y;}
  double cross(const Point_ & o) const {return static_cast<double>(x) * o.y - static_cast<double>(y) * o.x;}
  Point_ operator+(const Point_ & o) const {return {x + o.x, y + o.y};}
  Point_ operator-(const Point_ & o) const {return {x - o.x, y - o.y};}
  Point_ operator-() const {return {-x, -y};}
  Point_ operator*(double by) const {return {saturate_cast<T>(x * by), saturate_cast<T>(y * by)};}
  Point_ operator/(double by) const {return {saturate_cast<T>(x / by), saturate_cast<T>(y / by)};}
  Point_ & operator+=(const Point_ & o) {return *this = *this + o;}
  Point_ & operator-=(const Point_ & o) {return *this = *this - o;}
  bool operator==(const Point_ & o) const {return x == o.x && y == o.y;}
  bool operator!=(const Point_ & o) const {return !(*this == o);}
};
template<class T>
Point_<T> operator*(double by, const Point_<T> & point) {return point * by;}
template<class T>
double norm(const Point_<T> & point) {return std::hypot(static_cast<double>(point.x), static_cast<double>(point.y));}

template<class T>
struct Point3_
{
  using value_type = T;
  T x = 0, y = 0, z = 0;
  Point3_() = default;
  Point3_(T x_, T y_, T z_)
  : x(x_), y(y_), z(z_) {}
  T dot(const Point3_ & o) const {return x * o.x + y * o.y + z * o.z;}
  Point3_ operator+(const Point3_ & o) const {return {x + o.x, y + o.y, z + o.z};}
  Point3_ operator-(const Point3_ & o) const {return {x - o.x, y - o.y, z - o.z};}
};

template<class T>
struct Rect_
{
  using value_type = T;
  T x = 0, y = 0, width = 0, height = 0;
  Rect_() = default;
  Rect_(T x_, T y_, T width_, T height_)
  : x(x_), y(y_), width(width_), height(height_) {}
  Rect_(const Point_<T> & at, const Size_<T> & size)
  : x(at.x), y(at.y), width(size.width), height(size.height) {}
  Rect_(const Point_<T> & a, const Point_<T> & b)
  : x(std::min(a.x, b.x)), y(std::min(a.y, b.y)), width(std::max(a.x, b.x) - x), height(std::max(a.y, b.y) - y) {}
  template<class U>
  operator Rect_<U>() const
  {
    return {saturate_cast<U>(x), saturate_cast<U>(y), saturate_cast<U>(width), saturate_cast<U>(height)};
  }
  Point_<T> tl() const {return {x, y};}
  Point_<T> br() const {return {x + width, y + height};}
  Size_<T> size() const {return {width, height};}
  T area() const {return width * height;}
  bool empty() const {return width <= 0 || height <= 0;}
  bool contains(const Point_<T> & p) const {return x <= p.x && p.x < x + width && y <= p.y && p.y < y + height;}
  bool operator==(const Rect_ & o) const {return tl() == o.tl() && size() == o.size();}
  bool operator!=(const Rect_ & o) const {return !(*this == o);}
  /// What two rectangles have in common.
  Rect_ operator&(const Rect_ & o) const
  {
    T left = std::max(x, o.x), top = std::max(y, o.y);
    T right = std::min(x + width, o.x + o.width), bottom = std::min(y + height, o.y + o.height);
    return right <= left || bottom <= top ? Rect_() : Rect_(left, top, right - left, bottom - top);
  }
  /// The smallest rectangle around two.
  Rect_ operator|(const Rect_ & o) const
  {
    if (empty() || o.empty()) {
      return empty() ? o : *this;
    }
    Point_<T> from(std::min(x, o.x), std::min(y, o.y)), to(std::max(br().x, o.br().x), std::max(br().y, o.br().y));
    return Rect_(from, to);
  }
  Rect_ & operator&=(const Rect_ & o) {return *this = *this & o;}
  Rect_ & operator|=(const Rect_ & o) {return *this = *this | o;}
  Rect_ operator+(const Point_<T> & by) const {return {x + by.x, y + by.y, width, height};}
  Rect_ operator-(const Point_<T> & by) const {return {x - by.x, y - by.y, width, height};}
};

template<class T>
struct Scalar_ : Vec<T, 4>
{
  Scalar_() = default;
  Scalar_(T a, T b, T c = 0, T d = 0)
  : Vec<T, 4>(a, b, c, d) {}
  Scalar_(T a)  // NOLINT: as OpenCV's
  : Vec<T, 4>(a, 0, 0, 0) {}
  template<class U, int n>
  Scalar_(const Vec<U, n> & v)  // NOLINT: as OpenCV's
  {
    for (int i = 0; i < std::min(n, 4); ++i) {
      (*this)[i] = static_cast<T>(v[i]);
    }
  }
  static Scalar_ all(T value) {return {value, value, value, value};}
};

using Point2i = Point_<int>;
using Point2f = Point_<float>;
using Point2d = Point_<double>;
using Point = Point2i;
using Point3i = Point3_<int>;
using Point3f = Point3_<float>;
using Point3d = Point3_<double>;
using Size2i = Size_<int>;
using Size2f = Size_<float>;
using Size2d = Size_<double>;
using Size = Size2i;
using Rect2i = Rect_<int>;
using Rect2f = Rect_<float>;
using Rect2d = Rect_<double>;
using Rect = Rect2i;
using Scalar = Scalar_<double>;

struct Range
{
  int start = 0, end = 0;
  Range() = default;
  Range(int start_, int end_)
  : start(start_), end(end_) {}
  int size() const {return end - start;}
  bool empty() const {return start == end;}
  static Range all() {return {INT32_MIN, INT32_MAX};}
};

struct RotatedRect
{
  Point2f center;
  Size2f size;
  float angle = 0;
  RotatedRect() = default;
  RotatedRect(const Point2f & center_, const Size2f & size_, float angle_)
  : center(center_), size(size_), angle(angle_) {}
  /// The smallest upright rectangle around it, in whole pixels.
  Rect boundingRect() const
  {
    const Rect2f exact = boundingRect2f();
    const Point from(cvFloor(exact.x), cvFloor(exact.y));
    const Point2f to = exact.br();
    return {from.x, from.y, cvCeil(to.x) - from.x + 1, cvCeil(to.y) - from.y + 1};
  }
  Rect2f boundingRect2f() const
  {
    Point2f corners[4];
    points(corners);
    Point2f low = corners[0], high = corners[0];
    for (auto & corner : corners) {
      low = {std::min(low.x, corner.x), std::min(low.y, corner.y)};
      high = {std::max(high.x, corner.x), std::max(high.y, corner.y)};
    }
    return Rect2f(low, high);
  }
  /// The corners: bottom left, top left, top right, bottom right, where the angle is 0.
  void points(Point2f corners[]) const
  {
    double turn = angle * CV_PI / 180;
    float b = static_cast<float>(std::cos(turn)) * 0.5f, a = static_cast<float>(std::sin(turn)) * 0.5f;
    corners[0] = {center.x - a * size.height - b * size.width, center.y + b * size.height - a * size.width};
    corners[1] = {center.x + a * size.height - b * size.width, center.y - b * size.height - a * size.width};
    corners[2] = {2 * center.x - corners[0].x, 2 * center.y - corners[0].y};
    corners[3] = {2 * center.x - corners[1].x, 2 * center.y - corners[1].y};
  }
};

struct TermCriteria
{
  enum Type {COUNT = 1, MAX_ITER = COUNT, EPS = 2};
  int type = 0, maxCount = 0;
  double epsilon = 0;
  TermCriteria() = default;
  TermCriteria(int type_, int count, double epsilon_)
  : type(type_), maxCount(count), epsilon(epsilon_) {}
};

template<class T>
std::ostream & operator<<(std::ostream & out, const Size_<T> & size)
{
  return out << "[" << size.width << " x " << size.height << "]";
}
template<class T>
std::ostream & operator<<(std::ostream & out, const Point_<T> & at) {return out << "[" << at.x << ", " << at.y << "]";}
template<class T>
std::ostream & operator<<(std::ostream & out, const Point3_<T> & at)
{
  return out << "[" << at.x << ", " << at.y << ", " << at.z << "]";
}
template<class T>
std::ostream & operator<<(std::ostream & out, const Rect_<T> & rect)
{
  return out << "[" << rect.width << " x " << rect.height << " from (" << rect.x << ", " << rect.y << ")]";
}
}  // namespace cv
