// Small matrices that are inverted.
#pragma once
#include "opencv2/core/matx.hpp"

namespace cv
{
namespace detail
{
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
    if (std::abs(a(best, at)) < std::numeric_limits<T>::epsilon()) {
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
}  // namespace detail

template<class T, int m, int n>
Matx<T, n, m> Matx<T, m, n>::inv(int, bool * is_ok) const
{
  static_assert(m == n, "only square matrices are inverted here");
  Matx made = eye();
  const bool there = detail::eliminate(*this, made) != 0;
  if (is_ok) {
    *is_ok = there;
  }
  return there ? made : Matx();
}
template<class T, int n>
double determinant(const Matx<T, n, n> & small)
{
  auto other = small;
  return detail::eliminate(small, other);
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
