// Up to a number of values, without memory of their own.
#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <initializer_list>
#include <vector>

#include "tcb_span/span.hpp"

namespace rsl
{
template<class T, size_t capacity>
class StaticVector
{
public:
  StaticVector() = default;
  template<class C>
  StaticVector(const C & values)
  : size_(std::min<size_t>(values.size(), capacity))
  {
    assert(values.size() <= capacity);
    std::copy_n(values.begin(), size_, data_.begin());
  }
  StaticVector(std::initializer_list<T> values)
  : StaticVector(std::vector<T>(values)) {}

  auto begin() {return data_.begin();}
  auto begin() const {return data_.cbegin();}
  auto end() {return data_.begin() + size_;}
  auto end() const {return data_.cbegin() + size_;}
  operator tcb::span<T>() {return {data_.data(), size_};}
  operator tcb::span<const T>() const {return {data_.data(), size_};}

private:
  std::array<T, capacity> data_{};
  size_t size_ = 0;
};

template<class T, size_t capacity>
std::vector<T> to_vector(const StaticVector<T, capacity> & values) {return {values.begin(), values.end()};}
}  // namespace rsl
