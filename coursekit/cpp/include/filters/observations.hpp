// What filters over the last values share: these values, and whether there are as many channels as they were told.
#pragma once
#include <memory>
#include <vector>

#include "filters/filter_base.hpp"
#include "filters/realtime_circular_buffer.hpp"

namespace filters::impl
{
/// A filter that keeps the last `number_of_observations` of what it is given: `combine` makes one value of several.
template<class Base, typename T, typename Kept>
class Observations : public Base
{
protected:
  bool observe(const char * name, const Kept & zero)
  {
    if (!this->getParam("number_of_observations", number_of_observations_)) {
      RCLCPP_ERROR(this->logging_interface_->get_logger(), "%s did not find param number_of_observations", name);
      return false;
    }
    data_storage_ = std::make_unique<RealtimeCircularBuffer<Kept>>(number_of_observations_, zero);
    temp_storage_.resize(number_of_observations_);
    return true;
  }
  virtual T combine(std::vector<T> & values, size_t count) = 0;
  std::unique_ptr<RealtimeCircularBuffer<Kept>> data_storage_;
  std::vector<T> temp_storage_;
  size_t number_of_observations_ = 0;
};

/// Of one channel.
template<typename T>
class Observer : public Observations<FilterBase<T>, T, T>
{
public:
  bool update(const T & data_in, T & data_out) override
  {
    if (!this->configured_ || this->number_of_observations_ == 0) {
      return false;
    }
    this->data_storage_->push_back(data_in);
    std::copy_n(this->data_storage_->begin(), this->data_storage_->size(), this->temp_storage_.begin());
    data_out = this->combine(this->temp_storage_, this->data_storage_->size());
    return true;
  }

protected:
  bool observe(const char * name) {return Observations<FilterBase<T>, T, T>::observe(name, T());}
};

template<typename T>
bool has_channels(
  size_t wanted, const std::vector<T> & data_in, const std::vector<T> & data_out,
  const rclcpp::node_interfaces::NodeLoggingInterface::SharedPtr & log)
{
  if (data_in.size() == wanted && data_out.size() == wanted) {
    return true;
  }
  if (log) {
    RCLCPP_ERROR(
      log->get_logger(), "Configured with wrong size config:%zu in:%zu out:%zu", wanted, data_in.size(), data_out.size());
  }
  return false;
}

/// Of several channels.
template<typename T>
class MultiChannelObserver : public Observations<MultiChannelFilterBase<T>, T, std::vector<T>>
{
public:
  using MultiChannelFilterBase<T>::update;
  bool update(const std::vector<T> & data_in, std::vector<T> & data_out) override
  {
    if (!has_channels(this->number_of_channels_, data_in, data_out, this->logging_interface_)) {
      return false;
    }
    if (!this->configured_ || this->number_of_observations_ == 0) {
      return false;
    }
    this->data_storage_->push_back(data_in);
    for (size_t channel = 0; channel < this->number_of_channels_; ++channel) {
      for (size_t row = 0; row < this->data_storage_->size(); ++row) {
        this->temp_storage_[row] = this->data_storage_->at(row)[channel];
      }
      data_out[channel] = this->combine(this->temp_storage_, this->data_storage_->size());
    }
    return true;
  }

protected:
  bool observe(const char * name)
  {
    return Observations<MultiChannelFilterBase<T>, T, std::vector<T>>::observe(name, std::vector<T>(this->number_of_channels_));
  }
};
}  // namespace filters::impl
