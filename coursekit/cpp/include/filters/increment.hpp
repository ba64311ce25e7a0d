// One more than each value.
#pragma once
#include "filters/observations.hpp"

namespace filters
{
template<typename T>
class IncrementFilter : public FilterBase<T>
{
public:
  bool configure() override {return true;}
  bool update(const T & data_in, T & data_out) override
  {
    data_out = data_in + 1;
    return true;
  }
};

template<typename T>
class MultiChannelIncrementFilter : public MultiChannelFilterBase<T>
{
public:
  using MultiChannelFilterBase<T>::update;
  bool configure() override {return true;}
  bool update(const std::vector<T> & data_in, std::vector<T> & data_out) override
  {
    if (!impl::has_channels(this->number_of_channels_, data_in, data_out, this->logging_interface_)) {
      return false;
    }
    std::transform(data_in.begin(), data_in.end(), data_out.begin(), [](const T & one) {return one + 1;});
    return true;
  }
};
}  // namespace filters
