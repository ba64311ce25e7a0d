// Digital filters by a difference equation: a[0] y[n] = b[0] x[n] + b[1] x[n-1] + ... - a[1] y[n-1] - a[2] y[n-2] - ...
#pragma once
#include "filters/observations.hpp"

namespace filters
{
namespace impl
{
/// A filter's parameters `a` and `b`, and what one channel had before.
class DifferenceEquation
{
public:
  /// False where the first number by which all are divided is missing or 0, or there is none for what comes in.
  bool normalize()
  {
    if (a.empty() || b.empty() || a[0] == 0) {
      return false;
    }
    for (std::vector<double> * all : {&b, &a}) {
      for (size_t i = all == &a ? 1 : 0; i < all->size(); ++i) {
        (*all)[i] /= a[0];
      }
    }
    a[0] = 1;
    return true;
  }
  std::vector<double> a, b;
};
template<typename T>
class ChannelHistory
{
public:
  explicit ChannelHistory(const DifferenceEquation & of)
  : input_(of.b.size() - 1, T()), output_(of.a.size() - 1, T()) {}
  T next(const DifferenceEquation & by, const T & value)
  {
    T sum = static_cast<T>(by.b[0] * value);
    for (size_t i = 0; i < input_.size(); ++i) {
      sum += static_cast<T>(by.b[i + 1] * input_[i]);
    }
    for (size_t i = 0; i < output_.size(); ++i) {
      sum -= static_cast<T>(by.a[i + 1] * output_[i]);
    }
    input_.push_front(value);
    output_.push_front(sum);
    return sum;
  }

private:
  RealtimeCircularBuffer<T> input_, output_;
};
/// What both filters do to be configured: read a and b, and say which is missing.
template<typename T, class Base>
class TransferFunction : public Base
{
protected:
  bool read()
  {
    for (auto [name, numbers] : {std::pair("a", &equation_.a), std::pair("b", &equation_.b)}) {
      if (!this->getParam(name, *numbers)) {
        RCLCPP_ERROR(
          this->logging_interface_->get_logger(), "TransferFunctionFilter, \"%s\", params has no attribute %s.",
          this->getName().c_str(), name);
        return false;
      }
    }
    return equation_.normalize();
  }
  DifferenceEquation equation_;
  std::vector<ChannelHistory<T>> channels_;
};
}  // namespace impl

template<typename T>
class SingleChannelTransferFunctionFilter : public impl::TransferFunction<T, FilterBase<T>>
{
public:
  bool configure() override
  {
    if (!this->read()) {
      return false;
    }
    this->channels_.assign(1, impl::ChannelHistory<T>(this->equation_));
    return true;
  }
  bool update(const T & data_in, T & data_out) override
  {
    if (!this->configured_) {
      return false;
    }
    data_out = this->channels_[0].next(this->equation_, data_in);
    return true;
  }
};

template<typename T>
class MultiChannelTransferFunctionFilter : public impl::TransferFunction<T, MultiChannelFilterBase<T>>
{
public:
  using MultiChannelFilterBase<T>::update;
  bool configure() override
  {
    if (!this->read()) {
      return false;
    }
    this->channels_.assign(this->number_of_channels_, impl::ChannelHistory<T>(this->equation_));
    return true;
  }
  bool update(const std::vector<T> & data_in, std::vector<T> & data_out) override
  {
    if (!impl::has_channels(this->number_of_channels_, data_in, data_out, this->logging_interface_) || !this->configured_) {
      return false;
    }
    for (size_t channel = 0; channel < data_in.size(); ++channel) {
      data_out[channel] = this->channels_[channel].next(this->equation_, data_in[channel]);
    }
    return true;
  }
};
}  // namespace filters
