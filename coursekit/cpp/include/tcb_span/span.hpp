// A view of values that stand one behind the other.
#pragma once
#include <cstddef>
#include <type_traits>
#include <utility>

namespace tcb
{
template<class T>
class span
{
public:
  using element_type = T;
  using value_type = std::remove_cv_t<T>;
  using size_type = std::size_t;
  using iterator = T *;

  constexpr span() = default;
  constexpr span(T * first, std::size_t size)
  : first_(first), size_(size) {}
  template<std::size_t N>
  constexpr span(T (&values)[N])
  : span(values, N) {}
  template<class C, class = std::enable_if_t<std::is_convertible_v<decltype(std::declval<C &>().data()), T *>>>
  constexpr span(C & values)
  : span(values.data(), values.size()) {}

  constexpr T * data() const {return first_;}
  constexpr std::size_t size() const {return size_;}
  constexpr bool empty() const {return size_ == 0;}
  constexpr T & operator[](std::size_t i) const {return first_[i];}
  constexpr T & front() const {return first_[0];}
  constexpr T & back() const {return first_[size_ - 1];}
  constexpr iterator begin() const {return first_;}
  constexpr iterator end() const {return first_ + size_;}
  constexpr span subspan(std::size_t offset, std::size_t count) const {return {first_ + offset, count};}

private:
  T * first_ = nullptr;
  std::size_t size_ = 0;
};
}  // namespace tcb
