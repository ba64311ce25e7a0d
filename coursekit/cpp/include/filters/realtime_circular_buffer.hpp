// The last values of a row, in memory that is there from the beginning.
#pragma once
#include <algorithm>
#include <vector>

namespace filters
{
template<typename T>
class RealtimeCircularBuffer
{
public:
  RealtimeCircularBuffer(size_t size, const T & default_val)
  : values_(size, default_val) {}
  /// Behind the values that are there; once it is full the first one goes.
  void push_back(const T & item)
  {
    if (values_.empty()) {
      return;
    }
    if (counter_ >= values_.size()) {
      std::rotate(values_.begin(), values_.begin() + 1, values_.end());
    }
    values_[std::min(counter_++, values_.size() - 1)] = item;
  }
  /// Before all values; the last one goes.
  void push_front(const T & item)
  {
    if (values_.empty()) {
      return;
    }
    std::rotate(values_.begin(), values_.end() - 1, values_.end());
    values_.front() = item;
    counter_++;
  }
  void clear() {counter_ = 0;}
  auto begin() {return values_.begin();}
  auto end() {return values_.end();}
  T & front() {return values_.front();}
  T & back() {return counter_ < values_.size() ? values_[counter_] : values_.back();}
  /// How many values have come, at most how many it keeps.
  size_t size() {return std::min(counter_, values_.size());}
  bool empty() {return values_.empty();}
  T & at(size_t index) {return values_.at(index);}
  T & operator[](size_t index) {return values_[index];}

private:
  std::vector<T> values_;
  size_t counter_ = 0;
};
}  // namespace filters
