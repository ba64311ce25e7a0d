// The mean of the last values.
#pragma once
#include <cstddef>
#include <deque>
#include <cstddef>
#include <numeric>

namespace rcppmath
{
template<class T>
class RollingMeanAccumulator
{
public:
  explicit RollingMeanAccumulator(std::size_t rolling_window_size)
  : size_(rolling_window_size) {}
  void accumulate(T value)
  {
    values_.push_back(value);
    if (values_.size() > size_) {
      values_.pop_front();
    }
  }
  /// The mean of the values that there are, at most as many as the window has.
  T getRollingMean() const {return std::accumulate(values_.begin(), values_.end(), T{}) / values_.size();}

private:
  std::size_t size_;
  std::deque<T> values_;
};
}  // namespace rcppmath
