// Small matrices that are inverted.
#pragma once
#include "opencv2/core/matx.hpp"

namespace cv
{
template<class T, int n>
double determinant(const Matx<T, n, n> & small);

namespace detail
{
/// Below this a number to divide by counts as 0. As in OpenCV a matrix of up to 3 rows has its own rule: only 0 is 0, since
/// the covariance of small errors has small numbers.
template<class T, int n>
constexpr double negligible = n <= 3 ? 0 : std::numeric_limits<T>::epsilon() * (sizeof(T) == sizeof(float) ? 10 : 100);

/// Bring a square matrix to ones by the steps that bring `other` to its inverse; its determinant, 0 where there is none.
template<class T, int n>
double eliminate(Matx<T, n, n> a, Matx<T, n, n> & other)
{
  double volume = 1;
  for (int at = 0; at < n; ++at) {
    int best = at;
    for (int y = at + 1; y < n; ++y) {
      best = std::abs(a(y, at)) > std::abs(a(best, at)) ? y : best;
    }
    if (std::abs(a(best, at)) <= negligible<T, n>) {
      return 0;
    }
    if (best != at) {
      std::swap_ranges(&a.val[at * n], &a.val[at * n] + n, &a.val[best * n]);
      std::swap_ranges(&other.val[at * n], &other.val[at * n] + n, &other.val[best * n]);
      volume = -volume;
    }
    const T pivot = a(at, at);
    volume *= pivot;
    for (int x = 0; x < n; ++x) {
      a(at, x) /= pivot;
      other(at, x) /= pivot;
    }
    for (int y = 0; y < n; ++y) {
      const T by = y == at ? T() : a(y, at);
      for (int x = 0; x < n; ++x) {
        a(y, x) -= by * a(at, x);
        other(y, x) -= by * other(at, x);
      }
    }
  }
  return volume;
}
/// What stands at (y, x) of the inverse, times the determinant; counted round, so that the sign is right by itself.
template<class T>
T cofactor(const Matx<T, 2, 2> & a, int y, int x) {return y == x ? a(1 - y, 1 - x) : -a(y, x);}
template<class T>
T cofactor(const Matx<T, 3, 3> & a, int y, int x)
{
  const int y1 = (x + 1) % 3, y2 = (x + 2) % 3, x1 = (y + 1) % 3, x2 = (y + 2) % 3;
  return a(y1, x1) * a(y2, x2) - a(y1, x2) * a(y2, x1);
}
/// The sums of products tell that (1 2 3, 4 5 6, 7 8 9) has none, where elimination leaves a small rest.
template<class T, int n>
bool inverse(const Matx<T, n, n> & small, Matx<T, n, n> & made)
{
  if constexpr (n == 2 || n == 3) {
    const double volume = determinant(small);
    for (int i = 0; i < n * n && volume != 0; ++i) {
      made.val[i] = static_cast<T>(cofactor(small, i / n, i % n) / volume);
    }
    return volume != 0;
  } else {
    made = Matx<T, n, n>::eye();
    return eliminate(small, made) != 0;
  }
}
}  // namespace detail

/// DECOMP_CHOLESKY finds it as DECOMP_LU does; other methods ask OpenCV, so that DECOMP_SVD has a pseudo-inverse: zeros
/// only where it finds that a singular value is 0, as OpenCV has them.
template<class T, int m, int n>
Matx<T, n, m> Matx<T, m, n>::inv(int how, bool * is_ok) const
{
  Matx<T, n, m> made;
  bool there = false;
  if (how != DECOMP_LU && how != DECOMP_CHOLESKY) {
    there = invert(*this, made, how) != 0;
  } else if constexpr (m == n) {
    there = detail::inverse(*this, made);
  } else {
    CV_Error(-215, "A matrix that is not square has no inverse: use DECOMP_SVD for its pseudo-inverse");
  }
  if (is_ok) {
    *is_ok = there;
  }
  return there ? made : Matx<T, n, m>();
}
template<class T, int n>
double determinant(const Matx<T, n, n> & small)
{
  if constexpr (n == 2) {
    return small(0, 0) * small(1, 1) - small(0, 1) * small(1, 0);
  } else if constexpr (n == 3) {
    double sum = 0;
    for (int x = 0; x < n; ++x) {
      sum += small(0, x) * detail::cofactor(small, x, 0);
    }
    return sum;
  } else {
    auto other = small;
    return detail::eliminate(small, other);
  }
}
template<class T, int m, int n>
double trace(const Matx<T, m, n> & small)
{
  double sum = 0;
  for (int i = 0; i < std::min(m, n); ++i) {
    sum += small(i, i);
  }
  return sum;
}
template<class T, int m, int n>
double norm(const Matx<T, m, n> & small) {return std::sqrt(small.ddot(small));}
}  // namespace cv
