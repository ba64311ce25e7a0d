// Small matrices whose sizes the compiler knows.
#pragma once
#include <type_traits>

#include "opencv2/core/types.hpp"

namespace cv
{
template<class T, int m, int n>
class Matx
{
public:
  using value_type = T;
  static constexpr int rows = m, cols = n, channels = m * n;
  T val[m * n] = {};
  Matx() = default;
  template<class ... A, class = std::enable_if_t<sizeof...(A) == m * n && (std::is_arithmetic_v<A>&& ...)>>
  Matx(A... numbers)  // NOLINT: as OpenCV's
  : val{static_cast<T>(numbers)...} {}
  /// Row by row, from so many numbers.
  explicit Matx(const T * numbers) {std::copy(numbers, numbers + m * n, val);}
  static Matx all(T value)
  {
    Matx made;
    std::fill(made.val, made.val + m * n, value);
    return made;
  }
  static Matx zeros() {return Matx();}
  static Matx ones() {return all(1);}
  static Matx eye()
  {
    Matx made;
    for (int i = 0; i < std::min(m, n); ++i) {
      made(i, i) = 1;
    }
    return made;
  }
  T & operator()(int y, int x) {return val[y * n + x];}
  const T & operator()(int y, int x) const {return val[y * n + x];}
  T & operator()(int i) {return val[i];}
  const T & operator()(int i) const {return val[i];}
  Matx<T, n, m> t() const
  {
    Matx<T, n, m> turned;
    for (int y = 0; y < m; ++y) {
      for (int x = 0; x < n; ++x) {
        turned(x, y) = (*this)(y, x);
      }
    }
    return turned;
  }
  template<int k>
  Matx<T, m, k> operator*(const Matx<T, n, k> & o) const
  {
    Matx<T, m, k> made;
    for (int y = 0; y < m; ++y) {
      for (int x = 0; x < k; ++x) {
        for (int i = 0; i < n; ++i) {
          made(y, x) += (*this)(y, i) * o(i, x);
        }
      }
    }
    return made;
  }
  Vec<T, m> operator*(const Vec<T, n> & v) const
  {
    Vec<T, m> made;
    for (int y = 0; y < m; ++y) {
      for (int i = 0; i < n; ++i) {
        made[y] += (*this)(y, i) * v[i];
      }
    }
    return made;
  }
  Matx operator+(const Matx & o) const {return combined(o, 1);}
  Matx operator-(const Matx & o) const {return combined(o, -1);}
  Matx operator*(double by) const {return Matx().combined(*this, by);}
  bool operator==(const Matx & o) const {return std::equal(val, val + m * n, o.val);}
  bool operator!=(const Matx & o) const {return !(*this == o);}

private:
  Matx combined(const Matx & o, double by) const
  {
    Matx made;
    for (int i = 0; i < m * n; ++i) {
      made.val[i] = static_cast<T>(val[i] + o.val[i] * by);
    }
    return made;
  }
};
template<class T, int n>
Vec<T, 3> operator*(const Matx<T, 3, n> & by, const Point3_<T> & p)
{
  static_assert(n == 3, "a matrix that turns a point has three columns");
  return by * Vec<T, 3>(p.x, p.y, p.z);
}
using Matx22d = Matx<double, 2, 2>;
using Matx23d = Matx<double, 2, 3>;
using Matx33f = Matx<float, 3, 3>;
using Matx33d = Matx<double, 3, 3>;
using Matx34f = Matx<float, 3, 4>;
using Matx34d = Matx<double, 3, 4>;
using Matx31d = Matx<double, 3, 1>;
using Matx44d = Matx<double, 4, 4>;
}  // namespace cv
