// The allocator that C's functions ask for.
#pragma once
#include <stdlib.h>

/// Who gives memory and takes it back.
struct rcutils_allocator_t
{
  void * (* allocate)(size_t size, void * state);
  void (* deallocate)(void * pointer, void * state);
  void * (* reallocate)(void * pointer, size_t size, void * state);
  void * (* zero_allocate)(size_t number_of_elements, size_t size_of_element, void * state);
  void * state;
};
typedef rcutils_allocator_t rcl_allocator_t;
inline rcutils_allocator_t rcutils_get_default_allocator()
{
  return {
    [](size_t size, void *) {return malloc(size);}, [](void * pointer, void *) {free(pointer);},
    [](void * pointer, size_t size, void *) {return realloc(pointer, size);},
    [](size_t number, size_t size, void *) {return calloc(number, size);}, nullptr};
}
inline rcutils_allocator_t rcutils_get_zero_initialized_allocator() {return {};}
inline bool rcutils_allocator_is_valid(const rcutils_allocator_t * a)
{
  return a && a->allocate && a->deallocate && a->reallocate && a->zero_allocate;
}
/// Let memory grow; where that fails it is given back.
inline void * rcutils_reallocf(void * pointer, size_t size, rcutils_allocator_t * a)
{
  if (!rcutils_allocator_is_valid(a)) {
    return nullptr;
  }
  void * grown = a->reallocate(pointer, size, a->state);
  if (!grown) {
    a->deallocate(pointer, a->state);
  }
  return grown;
}
#define RCUTILS_CHECK_ALLOCATOR(allocator, otherwise) if (!rcutils_allocator_is_valid(allocator)) {otherwise;}
#define RCUTILS_CHECK_ALLOCATOR_WITH_MSG(allocator, message, otherwise) \
  if (!rcutils_allocator_is_valid(allocator)) { \
    RCUTILS_SET_ERROR_MSG(message); \
    otherwise; \
  }
inline rcl_allocator_t rcl_get_default_allocator() {return rcutils_get_default_allocator();}
