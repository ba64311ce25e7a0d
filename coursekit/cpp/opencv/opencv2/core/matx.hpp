// Small matrices whose sizes the compiler knows.
#pragma once
#include <functional>
#include <type_traits>

#include "opencv2/core/constants.hpp"
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
  static Matx diag(const Vec<T, (m < n ? m : n)> & numbers)
  {
    Matx made;
    for (int i = 0; i < std::min(m, n); ++i) {
      made(i, i) = numbers[i];
    }
    return made;
  }
  /// The same numbers in another type.
  template<class U>
  operator Matx<U, m, n>() const
  {
    Matx<U, m, n> made;
    std::transform(val, val + m * n, made.val, saturate_cast<U, T>);
    return made;
  }
  T & operator()(int y, int x) {return val[y * n + x];}
  const T & operator()(int y, int x) const {return val[y * n + x];}
  T & operator()(int i) {return val[i];}
  const T & operator()(int i) const {return val[i];}
  /// A part of it, from its upper left corner on.
  template<int rows_, int cols_>
  Matx<T, rows_, cols_> get_minor(int y, int x) const
  {
    Matx<T, rows_, cols_> part;
    for (int i = 0; i < rows_ * cols_; ++i) {
      part.val[i] = (*this)(y + i / cols_, x + i % cols_);
    }
    return part;
  }
  Matx<T, 1, n> row(int y) const {return Matx<T, 1, n>(val + y * n);}
  Matx<T, m, 1> col(int x) const {return get_minor<m, 1>(0, x);}
  Vec<T, (m < n ? m : n)> diag() const
  {
    Vec<T, (m < n ? m : n)> numbers;
    for (int i = 0; i < std::min(m, n); ++i) {
      numbers[i] = (*this)(i, i);
    }
    return numbers;
  }
  T dot(const Matx & o) const {return std::inner_product(val, val + m * n, o.val, T());}
  double ddot(const Matx & o) const {return std::inner_product(val, val + m * n, o.val, 0.0);}
  /// Number by number.
  Matx mul(const Matx & o) const
  {
    Matx made;
    std::transform(val, val + m * n, o.val, made.val, std::multiplies<T>());
    return made;
  }
  /// Zeros where there is none.
  Matx<T, n, m> inv(int how = DECOMP_LU, bool * is_ok = nullptr) const;
  /// x where this times x is b.
  template<int k>
  Matx<T, n, k> solve(const Matx<T, m, k> & b, int how = DECOMP_LU) const {return inv(how) * b;}
  Vec<T, n> solve(const Vec<T, m> & b, int how = DECOMP_LU) const {return inv(how) * b;}
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
  Matx operator-() const {return *this * -1;}
  Matx operator*(double by) const {return Matx().combined(*this, by);}
  Matx operator/(double by) const {return *this * (1 / by);}
  Matx & operator+=(const Matx & o) {return *this = *this + o;}
  Matx & operator-=(const Matx & o) {return *this = *this - o;}
  Matx & operator*=(double by) {return *this = *this * by;}
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
template<class T, int m, int n>
Matx<T, m, n> operator*(double by, const Matx<T, m, n> & small) {return small * by;}
#define COURSEKIT_MATX(m, n) \
  using Matx ## m ## n ## f = Matx<float, m, n>; \
  using Matx ## m ## n ## d = Matx<double, m, n>;
COURSEKIT_MATX(1, 2) COURSEKIT_MATX(1, 3) COURSEKIT_MATX(1, 4) COURSEKIT_MATX(1, 6)
COURSEKIT_MATX(2, 1) COURSEKIT_MATX(2, 2) COURSEKIT_MATX(2, 3)
COURSEKIT_MATX(3, 1) COURSEKIT_MATX(3, 2) COURSEKIT_MATX(3, 3) COURSEKIT_MATX(3, 4)
COURSEKIT_MATX(4, 1) COURSEKIT_MATX(4, 3) COURSEKIT_MATX(4, 4)
COURSEKIT_MATX(6, 1) COURSEKIT_MATX(6, 6)
#undef COURSEKIT_MATX
}  // namespace cv

#include "opencv2/core/matx.inl.hpp"
