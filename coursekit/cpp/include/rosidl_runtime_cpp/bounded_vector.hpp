// A vector of at most so many items, as messages have them for `T[<=N]`: what would be more is refused, and changes nothing.
#pragma once
#include <initializer_list>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace rosidl_runtime_cpp
{
template<typename Tp, std::size_t UpperBound, typename Alloc = std::allocator<Tp>>
class BoundedVector : protected std::vector<Tp, Alloc>
{
  using Base = std::vector<Tp, Alloc>;
  template<typename Iterator>
  using AnIterator = typename std::iterator_traits<Iterator>::iterator_category;

public:
  using typename Base::allocator_type;
  using typename Base::const_iterator;
  using typename Base::const_pointer;
  using typename Base::const_reference;
  using typename Base::const_reverse_iterator;
  using typename Base::difference_type;
  using typename Base::iterator;
  using typename Base::pointer;
  using typename Base::reference;
  using typename Base::reverse_iterator;
  using typename Base::size_type;
  using typename Base::value_type;

  BoundedVector() = default;
  explicit BoundedVector(const Alloc & allocator)
  : Base(allocator) {}
  explicit BoundedVector(size_type count, const Alloc & allocator = Alloc())
  : Base(allowed(count), allocator) {}
  BoundedVector(size_type count, const Tp & value, const Alloc & allocator = Alloc())
  : Base(allowed(count), value, allocator) {}
  BoundedVector(std::initializer_list<Tp> items, const Alloc & allocator = Alloc())
  : Base((allowed(items.size()), items), allocator) {}
  template<typename Iterator, typename = AnIterator<Iterator>>
  BoundedVector(Iterator first, Iterator last, const Alloc & allocator = Alloc())
  : Base(first, last, allocator) {allowed(size());}
  BoundedVector & operator=(std::initializer_list<Tp> items)
  {
    assign(items);
    return *this;
  }

  using Base::operator[];
  using Base::at;
  using Base::back;
  using Base::begin;
  using Base::capacity;
  using Base::cbegin;
  using Base::cend;
  using Base::clear;
  using Base::crbegin;
  using Base::crend;
  using Base::empty;
  using Base::end;
  using Base::erase;
  using Base::front;
  using Base::get_allocator;
  using Base::pop_back;
  using Base::rbegin;
  using Base::rend;
  using Base::shrink_to_fit;
  using Base::size;

  size_type max_size() const noexcept {return UpperBound < Base::max_size() ? UpperBound : Base::max_size();}
  template<typename T = Tp, std::enable_if_t<!std::is_same_v<T, bool>> * = nullptr>
  T * data() noexcept {return Base::data();}
  template<typename T = Tp, std::enable_if_t<!std::is_same_v<T, bool>> * = nullptr>
  const T * data() const noexcept {return Base::data();}

  void assign(size_type count, const Tp & value) {Base::assign(allowed(count), value);}
  void assign(std::initializer_list<Tp> items) {assign(items.begin(), items.end());}
  template<typename Iterator, typename = AnIterator<Iterator>>
  void assign(Iterator first, Iterator last) {*this = BoundedVector(first, last);}
  void resize(size_type count) {Base::resize(allowed(count));}
  void resize(size_type count, const Tp & value) {Base::resize(allowed(count), value);}
  void reserve(size_type count) {Base::reserve(allowed(count));}

  void push_back(const Tp & item) {emplace_back(item);}
  void push_back(Tp && item) {emplace_back(std::move(item));}
  template<typename ... Args>
  decltype(auto) emplace_back(Args && ... args)
  {
    more(1);
    return Base::emplace_back(std::forward<Args>(args) ...);
  }
  template<typename ... Args>
  iterator emplace(const_iterator where, Args && ... args)
  {
    more(1);
    return Base::emplace(where, std::forward<Args>(args) ...);
  }
  iterator insert(const_iterator where, const Tp & item) {return emplace(where, item);}
  iterator insert(const_iterator where, Tp && item) {return emplace(where, std::move(item));}
  iterator insert(const_iterator where, size_type count, const Tp & item)
  {
    more(count);
    return Base::insert(where, count, item);
  }
  iterator insert(const_iterator where, std::initializer_list<Tp> items) {return insert(where, items.begin(), items.end());}
  template<typename Iterator, typename = AnIterator<Iterator>>
  iterator insert(const_iterator where, Iterator first, Iterator last)
  {
    const Base items(first, last);  // also those of a stream, which can be read once
    more(items.size());
    return Base::insert(where, items.begin(), items.end());
  }
  void swap(BoundedVector & other) noexcept {Base::swap(other);}
  friend void swap(BoundedVector & one, BoundedVector & other) noexcept {one.swap(other);}

#define COURSEKIT_COMPARED_BY(sign) \
  friend bool operator sign(const BoundedVector & one, const BoundedVector & other) {return one.items() sign other.items();}
  COURSEKIT_COMPARED_BY(==)
  COURSEKIT_COMPARED_BY(!=)
  COURSEKIT_COMPARED_BY(<)
  COURSEKIT_COMPARED_BY(<=)
  COURSEKIT_COMPARED_BY(>)
  COURSEKIT_COMPARED_BY(>=)
#undef COURSEKIT_COMPARED_BY

private:
  const Base & items() const {return *this;}
  static size_type allowed(size_type count)
  {
    if (count > UpperBound) {
      throw std::length_error("Exceeded upper bound");
    }
    return count;
  }
  void more(size_type count) const {allowed(count > UpperBound ? count : size() + count);}
};
}  // namespace rosidl_runtime_cpp
