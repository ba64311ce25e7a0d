// The allocator of real-time demos by its name. Its memory is the heap's: a simulation keeps no bounds on a call's time.
#pragma once
#include <cstdlib>
#include <new>

#include "rcl/allocator.h"

template<typename T, size_t DefaultPoolSize = 1024 * 1024>
struct tlsf_heap_allocator
{
  using value_type = T;
  explicit tlsf_heap_allocator(size_t size = DefaultPoolSize)
  : pool_size(size) {}
  template<typename U, size_t OtherSize>
  tlsf_heap_allocator(const tlsf_heap_allocator<U, OtherSize> & other)
  : memory_pool(other.memory_pool), pool_size(other.pool_size) {}
  template<typename U>
  struct rebind
  {
    typedef tlsf_heap_allocator<U, DefaultPoolSize> other;
  };

  size_t initialize(size_t size) {return pool_size = size;}
  T * allocate(size_t size)
  {
    void * memory = std::malloc(size * sizeof(T));
    if (!memory && size > 0) {
      throw std::bad_alloc();
    }
    return static_cast<T *>(memory);
  }
  void deallocate(T * memory, size_t) {std::free(memory);}
  rcl_allocator_t get_rcl_allocator() {return rcl_get_default_allocator();}

  char * memory_pool = nullptr;
  size_t pool_size;
};
template<typename T, typename U, size_t X, size_t Y>
constexpr bool operator==(const tlsf_heap_allocator<T, X> & a, const tlsf_heap_allocator<U, Y> & b) noexcept
{
  return a.memory_pool == b.memory_pool;
}
template<typename T, typename U, size_t X, size_t Y>
constexpr bool operator!=(const tlsf_heap_allocator<T, X> & a, const tlsf_heap_allocator<U, Y> & b) noexcept
{
  return !(a == b);
}
