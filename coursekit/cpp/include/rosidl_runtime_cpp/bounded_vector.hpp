// A vector of at most so many items, as messages have them for `T[<=N]`.
#pragma once
#include <initializer_list>
#include <stdexcept>
#include <vector>

namespace rosidl_runtime_cpp
{
template<class T, std::size_t N, class Allocator = std::allocator<T>>
struct BoundedVector : std::vector<T>
{
  using Base = std::vector<T>;
  BoundedVector() = default;
  explicit BoundedVector(std::size_t size)
  : Base(checked(size)) {}
  BoundedVector(std::size_t size, const T & value)
  : Base(checked(size), value) {}
  BoundedVector(const Base & items)  // NOLINT: assigned from a vector, as upstream's
  : Base(items) {check(items.size());}
  BoundedVector(std::initializer_list<T> items)
  : Base(items) {check(items.size());}
  template<class Iterator, class = typename std::iterator_traits<Iterator>::iterator_category>
  BoundedVector(Iterator first, Iterator last)
  : Base(first, last) {check(Base::size());}

  static void check(std::size_t size)
  {
    if (size > N) {
      throw std::length_error("Exceeded upper bound");
    }
  }
  static std::size_t checked(std::size_t size)
  {
    check(size);
    return size;
  }
  std::size_t max_size() const {return N;}
  void push_back(const T & item)
  {
    check(Base::size() + 1);
    Base::push_back(item);
  }
  template<class ... Args>
  auto & emplace_back(Args && ... args)
  {
    check(Base::size() + 1);
    return Base::emplace_back(std::forward<Args>(args) ...);
  }
  void resize(std::size_t size) {Base::resize(checked(size));}
  void resize(std::size_t size, const T & value) {Base::resize(checked(size), value);}
  void reserve(std::size_t size) {Base::reserve(checked(size));}
  template<class ... Args>
  void assign(Args && ... args)
  {
    BoundedVector made(std::forward<Args>(args) ...);
    Base::swap(made);
  }
};
}  // namespace rosidl_runtime_cpp
