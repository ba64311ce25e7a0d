// The median of the last `number_of_observations` values: of an even number of them the smaller of the middle two.
#pragma once
#include "filters/observations.hpp"

namespace filters
{
namespace impl
{
template<typename T>
T median_of(std::vector<T> & values, size_t count)
{
  auto middle = values.begin() + static_cast<std::ptrdiff_t>((count - 1) / 2);
  std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
  return *middle;
}
}  // namespace impl

template<typename T>
class MedianFilter : public impl::Observer<T>
{
public:
  bool configure() override {return this->observe("MedianFilter");}

private:
  T combine(std::vector<T> & values, size_t count) override {return impl::median_of(values, count);}
};

template<typename T>
class MultiChannelMedianFilter : public impl::MultiChannelObserver<T>
{
public:
  bool configure() override {return this->observe("MultiChannelMedianFilter");}

private:
  T combine(std::vector<T> & values, size_t count) override {return impl::median_of(values, count);}
};
}  // namespace filters
