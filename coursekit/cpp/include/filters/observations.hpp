// What filters over the last values share: these values, and whether there are as many channels as they were told.
#pragma once
#include <memory>
#include <vector>

#include "filters/filter_base.hpp"
#include "filters/realtime_circular_buffer.hpp"

namespace filters::impl
{
/// A filter of one channel: `combine` makes one value of the last `number_of_observations`.
template<typename T>
class Observer : public FilterBase<T>
{
public:
  bool update(const T & data_in, T & data_out) override
  {
    if (!this->configured_ || number_of_observations_ == 0) {
      return false;
    }
    data_storage_->push_back(data_in);
    std::copy_n(data_storage_->begin(), data_storage_->size(), temp_storage_.begin());
    data_out = combine(temp_storage_, data_storage_->size());
    return true;
  }

protected:
  bool observe(const char * name)
  {
    if (!this->getParam("number_of_observations", number_of_observations_)) {
      RCLCPP_ERROR(this->logging_interface_->get_logger(), "%s did not find param number_of_observations", name);
      return false;
    }
    data_storage_ = std::make_unique<RealtimeCircularBuffer<T>>(number_of_observations_, T());
    temp_storage_.resize(number_of_observations_);
    return true;
  }
  virtual T combine(std::vector<T> & values, size_t count) = 0;
  std::unique_ptr<RealtimeCircularBuffer<T>> data_storage_;
  std::vector<T> temp_storage_;
  size_t number_of_observations_ = 0;
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

/// A filter of several channels, each as `Observer` has one.
template<typename T>
class MultiChannelObserver : public MultiChannelFilterBase<T>
{
public:
  using MultiChannelFilterBase<T>::update;
  bool update(const std::vector<T> & data_in, std::vector<T> & data_out) override
  {
    if (!has_channels(this->number_of_channels_, data_in, data_out, this->logging_interface_)) {
      return false;
    }
    if (!this->configured_ || number_of_observations_ == 0) {
      return false;
    }
    data_storage_->push_back(data_in);
    for (size_t channel = 0; channel < this->number_of_channels_; ++channel) {
      for (size_t row = 0; row < data_storage_->size(); ++row) {
        temp_storage_[row] = data_storage_->at(row)[channel];
      }
      data_out[channel] = combine(temp_storage_, data_storage_->size());
    }
    return true;
  }

protected:
  bool observe(const char * name)
  {
    if (!this->getParam("number_of_observations", number_of_observations_)) {
      RCLCPP_ERROR(this->logging_interface_->get_logger(), "%s did not find param number_of_observations", name);
      return false;
    }
    data_storage_ = std::make_unique<RealtimeCircularBuffer<std::vector<T>>>(
      number_of_observations_, std::vector<T>(this->number_of_channels_));
    temp_storage_.resize(number_of_observations_);
    return true;
  }
  virtual T combine(std::vector<T> & values, size_t count) = 0;
  std::unique_ptr<RealtimeCircularBuffer<std::vector<T>>> data_storage_;
  std::vector<T> temp_storage_;
  size_t number_of_observations_ = 0;
};
}  // namespace filters::impl
