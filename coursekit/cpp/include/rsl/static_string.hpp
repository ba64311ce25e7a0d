// Up to a number of characters, without memory of their own.
#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <string_view>

namespace rsl
{
template<size_t capacity>
class StaticString
{
public:
  StaticString() = default;
  StaticString(const std::string & text)
  : size_(std::min(text.size(), capacity))
  {
    assert(text.size() <= capacity);
    std::copy_n(text.begin(), size_, data_.begin());
  }
  StaticString(const char * text)
  : StaticString(std::string(text)) {}

  auto begin() const {return data_.cbegin();}
  auto end() const {return data_.cbegin() + size_;}
  operator std::string_view() const {return {data_.data(), size_};}

private:
  std::array<char, capacity> data_{};
  size_t size_ = 0;
};

template<size_t capacity>
std::string to_string(const StaticString<capacity> & text) {return {text.begin(), text.end()};}
}  // namespace rsl
