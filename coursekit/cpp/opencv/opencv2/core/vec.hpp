// Numbers of a pixel: how they are clipped, and small vectors of them; the types of matrices.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <ostream>
#include <type_traits>

using uchar = unsigned char;
using schar = signed char;
using ushort = unsigned short;  // NOLINT: OpenCV's own names
using uint = unsigned int;
using int64 = int64_t;
using uint64 = uint64_t;

#define CV_8U 0
#define CV_8S 1
#define CV_16U 2
#define CV_16S 3
#define CV_32S 4
#define CV_32F 5
#define CV_64F 6
#define CV_CN_SHIFT 3
#define CV_CN_MAX 512
#define CV_MAT_DEPTH(type) ((type) & 7)
#define CV_MAT_CN(type) ((((type) >> CV_CN_SHIFT) & (CV_CN_MAX - 1)) + 1)
#define CV_MAKETYPE(depth, cn) (CV_MAT_DEPTH(depth) + (((cn) - 1) << CV_CN_SHIFT))
#define CV_MAKE_TYPE CV_MAKETYPE
#define CV_8UC(n) CV_MAKETYPE(CV_8U, (n))
#define CV_16UC(n) CV_MAKETYPE(CV_16U, (n))
#define CV_32FC(n) CV_MAKETYPE(CV_32F, (n))
#define CV_64FC(n) CV_MAKETYPE(CV_64F, (n))
enum
{
#define COURSEKIT_TYPES(depth) \
  depth ## C1 = CV_MAKETYPE(depth, 1), depth ## C2 = CV_MAKETYPE(depth, 2), \
  depth ## C3 = CV_MAKETYPE(depth, 3), depth ## C4 = CV_MAKETYPE(depth, 4),
  COURSEKIT_TYPES(CV_8U) COURSEKIT_TYPES(CV_8S) COURSEKIT_TYPES(CV_16U) COURSEKIT_TYPES(CV_16S)
  COURSEKIT_TYPES(CV_32S) COURSEKIT_TYPES(CV_32F) COURSEKIT_TYPES(CV_64F)
#undef COURSEKIT_TYPES
};

namespace cv
{
using ::schar;
using ::uchar;
using ::uint;
using ::ushort;

/// A number as another type: whole ones are rounded (halves to even) and clipped to their range.
template<class T, class U>
T saturate_cast(U value)
{
  if constexpr (std::is_integral_v<T>) {
    double wanted = std::is_floating_point_v<U>? std::nearbyint(static_cast<double>(value)) : static_cast<double>(value);
    double low = static_cast<double>(std::numeric_limits<T>::min());
    double high = static_cast<double>(std::numeric_limits<T>::max());
    return static_cast<T>(std::min(std::max(wanted, low), high));
  } else {
    return static_cast<T>(value);
  }
}
inline int cvRound(double value) {return static_cast<int>(std::nearbyint(value));}
inline int cvFloor(double value) {return static_cast<int>(std::floor(value));}
inline int cvCeil(double value) {return static_cast<int>(std::ceil(value));}

template<class T, int n>
struct Vec
{
  using value_type = T;
  static constexpr int channels = n;
  T val[n] = {};
  Vec() = default;
  template<class ... A, class = std::enable_if_t<sizeof...(A) == n && (std::is_arithmetic_v<A>&& ...)>>
  Vec(A... numbers)  // NOLINT: as OpenCV's
  : val{static_cast<T>(numbers)...} {}
  /// From so many numbers.
  explicit Vec(const T * numbers) {std::copy(numbers, numbers + n, val);}
  /// The same numbers in another type, clipped to its range.
  template<class U>
  operator Vec<U, n>() const
  {
    Vec<U, n> made;
    std::transform(val, val + n, made.val, saturate_cast<U, T>);
    return made;
  }
  T & operator[](int i) {return val[i];}
  const T & operator[](int i) const {return val[i];}
  T & operator()(int i) {return val[i];}
  const T & operator()(int i) const {return val[i];}
  static Vec all(T value)
  {
    Vec made;
    std::fill(made.val, made.val + n, value);
    return made;
  }
  Vec operator+(const Vec & o) const {return combined(o, [](auto a, auto b) {return a + b;});}
  Vec operator-(const Vec & o) const {return combined(o, [](auto a, auto b) {return a - b;});}
  Vec operator*(double by) const {return combined(*this, [by](auto a, auto) {return a * by;});}
  Vec operator/(double by) const {return combined(*this, [by](auto a, auto) {return a / by;});}
  Vec operator-() const {return *this * -1;}
  Vec & operator*=(double by) {return *this = *this * by;}
  Vec & operator/=(double by) {return *this = *this / by;}
  /// Number by number.
  Vec mul(const Vec & o) const {return combined(o, [](auto a, auto b) {return a * b;});}
  T dot(const Vec & o) const {return std::inner_product(val, val + n, o.val, T());}
  double ddot(const Vec & o) const {return std::inner_product(val, val + n, o.val, 0.0);}
  Vec cross(const Vec & o) const
  {
    static_assert(n == 3, "a cross product is of three numbers each");
    return Vec(val[1] * o[2] - val[2] * o[1], val[2] * o[0] - val[0] * o[2], val[0] * o[1] - val[1] * o[0]);
  }
  Vec & operator+=(const Vec & o) {return *this = *this + o;}
  Vec & operator-=(const Vec & o) {return *this = *this - o;}
  bool operator==(const Vec & o) const {return std::equal(val, val + n, o.val);}
  bool operator!=(const Vec & o) const {return !(*this == o);}

private:
  template<class F>
  Vec combined(const Vec & o, F how) const
  {
    Vec made;
    for (int i = 0; i < n; ++i) {
      made[i] = saturate_cast<T>(how(val[i], o[i]));
    }
    return made;
  }
};
template<class T, int n>
Vec<T, n> operator*(double by, const Vec<T, n> & v) {return v * by;}
template<class T, int n>
double norm(const Vec<T, n> & v)
{
  double sum = 0;
  for (T one : v.val) {
    sum += static_cast<double>(one) * one;
  }
  return std::sqrt(sum);
}
template<class T, int n>
Vec<T, n> normalize(const Vec<T, n> & v)
{
  const double length = norm(v);
  return v * (length != 0 ? 1 / length : 0);
}
template<class T, int n>
std::ostream & operator<<(std::ostream & out, const Vec<T, n> & v)
{
  for (int i = 0; i < n; ++i) {
    out << (i ? ", " : "[") << +v[i];
  }
  return out << "]";
}
using Vec2b = Vec<uchar, 2>;
using Vec3b = Vec<uchar, 3>;
using Vec4b = Vec<uchar, 4>;
using Vec2s = Vec<short, 2>;  // NOLINT: OpenCV's own names
using Vec3s = Vec<short, 3>;  // NOLINT
using Vec4s = Vec<short, 4>;  // NOLINT
using Vec2w = Vec<ushort, 2>;
using Vec3w = Vec<ushort, 3>;
using Vec4w = Vec<ushort, 4>;
using Vec2i = Vec<int, 2>;
using Vec3i = Vec<int, 3>;
using Vec4i = Vec<int, 4>;
using Vec6i = Vec<int, 6>;
using Vec8i = Vec<int, 8>;
using Vec2f = Vec<float, 2>;
using Vec3f = Vec<float, 3>;
using Vec4f = Vec<float, 4>;
using Vec6f = Vec<float, 6>;
using Vec2d = Vec<double, 2>;
using Vec3d = Vec<double, 3>;
using Vec4d = Vec<double, 4>;
using Vec6d = Vec<double, 6>;

/// The depth and the number of channels of what a matrix may hold.
template<class T>
struct DataType;
#define COURSEKIT_DEPTH(T, code) \
  template<> \
  struct DataType<T> \
  { \
    using channel_type = T; \
    static constexpr int depth = code, channels = 1, type = CV_MAKETYPE(code, 1); \
  };
COURSEKIT_DEPTH(uchar, CV_8U)
COURSEKIT_DEPTH(schar, CV_8S)
COURSEKIT_DEPTH(char, CV_8S)
COURSEKIT_DEPTH(ushort, CV_16U)
COURSEKIT_DEPTH(short, CV_16S)  // NOLINT
COURSEKIT_DEPTH(int, CV_32S)
COURSEKIT_DEPTH(float, CV_32F)
COURSEKIT_DEPTH(double, CV_64F)
#undef COURSEKIT_DEPTH
template<class T, int n>
struct DataTypeOf
{
  using channel_type = T;
  static constexpr int depth = DataType<T>::depth, channels = n, type = CV_MAKETYPE(depth, n);
};
template<class T, int n>
struct DataType<Vec<T, n>> : DataTypeOf<T, n> {};
template<class T>
struct Point_;
template<class T>
struct Point3_;
template<class T>
struct Size_;
template<class T>
struct Rect_;
template<class T>
struct Scalar_;
template<class T>
struct DataType<Point_<T>> : DataTypeOf<T, 2> {};
template<class T>
struct DataType<Size_<T>> : DataTypeOf<T, 2> {};
template<class T>
struct DataType<Point3_<T>> : DataTypeOf<T, 3> {};
template<class T>
struct DataType<Rect_<T>> : DataTypeOf<T, 4> {};
template<class T>
struct DataType<Scalar_<T>> : DataTypeOf<T, 4> {};
}  // namespace cv
using cv::cvCeil;
using cv::cvFloor;
using cv::cvRound;
