// The mean of the last `number_of_observations` values.
#pragma once
#include <numeric>

#include "filters/observations.hpp"

namespace filters
{
namespace impl
{
template<typename T>
T mean_of(const std::vector<T> & values, size_t count)
{
  return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(count), T()) / static_cast<T>(count);
}
}  // namespace impl

template<typename T>
class MeanFilter : public impl::Observer<T>
{
public:
  bool configure() override {return this->observe("MeanFilter");}

private:
  T combine(std::vector<T> & values, size_t count) override {return impl::mean_of(values, count);}
};

template<typename T>
class MultiChannelMeanFilter : public impl::MultiChannelObserver<T>
{
public:
  bool configure() override {return this->observe("MultiChannelMeanFilter");}

private:
  T combine(std::vector<T> & values, size_t count) override {return impl::mean_of(values, count);}
};
}  // namespace filters
