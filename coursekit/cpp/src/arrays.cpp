// Lists of texts and bytes in C, in the memory of the allocator that each is made with.
#include <algorithm>
#include <cstdio>
#include <vector>

#include "rcutils/error_handling.h"
#include "rcutils/types.h"

namespace
{
rcutils_ret_t fail(rcutils_ret_t how, const char * why)
{
  RCUTILS_SET_ERROR_MSG(why);
  return how;
}
/// Whether an array is there and may ask for memory; says why where not.
template<class Array>
rcutils_ret_t usable(const Array * array)
{
  if (!array) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "array argument is null");
  }
  return rcutils_allocator_is_valid(&array->allocator) ?
         RCUTILS_RET_OK : fail(RCUTILS_RET_INVALID_ARGUMENT, "array has no valid allocator");
}
template<class Array>
rcutils_ret_t init(Array * array, const rcutils_allocator_t * allocator, Array empty)
{
  if (!array || !allocator) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "array or allocator argument is null");
  }
  *array = empty;
  array->allocator = *allocator;
  return usable(array);
}

bool is_own(const rcutils_uint8_array_t *) {return true;}
bool is_own(const rcutils_char_array_t * array) {return array->owns_buffer;}
void become_own(rcutils_uint8_array_t *) {}
void become_own(rcutils_char_array_t * array) {array->owns_buffer = true;}

template<class Array>
rcutils_ret_t resize(Array * array, size_t capacity)
{
  const rcutils_ret_t usable_ = usable(array);
  if (usable_ != RCUTILS_RET_OK || !capacity) {
    return usable_ ? usable_ : fail(RCUTILS_RET_INVALID_ARGUMENT, "new size of array has to be greater than zero");
  }
  if (capacity == array->buffer_capacity) {
    return RCUTILS_RET_OK;
  }
  const auto & from = array->allocator;
  const size_t length = std::min(array->buffer_length, capacity);
  void * grown = from.reallocate(is_own(array) ? array->buffer : nullptr, capacity, from.state);
  if (!grown) {
    return fail(RCUTILS_RET_BAD_ALLOC, "failed to allocate memory for array");
  }
  if (!is_own(array) && length) {
    memcpy(grown, array->buffer, length);
  }
  become_own(array);
  array->buffer = static_cast<decltype(array->buffer)>(grown);
  array->buffer_capacity = capacity;
  array->buffer_length = length;
  return RCUTILS_RET_OK;
}
template<class Array>
rcutils_ret_t fini(Array * array)
{
  const rcutils_ret_t usable_ = usable(array);
  if (usable_ == RCUTILS_RET_OK && array->buffer) {
    if (is_own(array)) {
      array->allocator.deallocate(array->buffer, array->allocator.state);
    }
    array->buffer = nullptr;
    array->buffer_length = array->buffer_capacity = 0;
  }
  return usable_;
}
}  // namespace

rcutils_ret_t rcutils_uint8_array_init(rcutils_uint8_array_t * array, size_t capacity, const rcutils_allocator_t * allocator)
{
  const rcutils_ret_t done = init(array, allocator, rcutils_get_zero_initialized_uint8_array());
  return done == RCUTILS_RET_OK && capacity ? resize(array, capacity) : done;
}
rcutils_ret_t rcutils_uint8_array_resize(rcutils_uint8_array_t * array, size_t capacity) {return resize(array, capacity);}
rcutils_ret_t rcutils_uint8_array_fini(rcutils_uint8_array_t * array) {return fini(array);}

rcutils_ret_t rcutils_char_array_init(rcutils_char_array_t * array, size_t capacity, const rcutils_allocator_t * allocator)
{
  rcutils_ret_t done = init(array, allocator, rcutils_get_zero_initialized_char_array());
  if (done == RCUTILS_RET_OK && capacity && (done = resize(array, capacity)) == RCUTILS_RET_OK) {
    array->buffer[0] = '\0';
  }
  return done;
}
rcutils_ret_t rcutils_char_array_resize(rcutils_char_array_t * array, size_t capacity) {return resize(array, capacity);}
rcutils_ret_t rcutils_char_array_expand_as_needed(rcutils_char_array_t * array, size_t capacity)
{
  return array && capacity <= array->buffer_capacity ? RCUTILS_RET_OK : resize(array, capacity);
}
rcutils_ret_t rcutils_char_array_fini(rcutils_char_array_t * array) {return fini(array);}

rcutils_ret_t rcutils_char_array_memcpy(rcutils_char_array_t * array, const char * letters, size_t count)
{
  const rcutils_ret_t done = rcutils_char_array_expand_as_needed(array, count);
  if (done == RCUTILS_RET_OK) {
    memcpy(array->buffer, letters, count);
    array->buffer_length = count;
  }
  return done;
}
rcutils_ret_t rcutils_char_array_strcpy(rcutils_char_array_t * array, const char * text)
{
  return rcutils_char_array_memcpy(array, text, strlen(text) + 1);
}
rcutils_ret_t rcutils_char_array_strncat(rcutils_char_array_t * array, const char * text, size_t length)
{
  const size_t before = array && array->buffer_length ? array->buffer_length - 1 : 0, more = strnlen(text, length);
  const rcutils_ret_t done = rcutils_char_array_expand_as_needed(array, before + more + 1);
  if (done == RCUTILS_RET_OK) {
    memcpy(array->buffer + before, text, more);
    array->buffer[before + more] = '\0';
    array->buffer_length = before + more + 1;
  }
  return done;
}
rcutils_ret_t rcutils_char_array_strcat(rcutils_char_array_t * array, const char * text)
{
  return rcutils_char_array_strncat(array, text, SIZE_MAX);
}
rcutils_ret_t rcutils_char_array_vsprintf(rcutils_char_array_t * array, const char * format, va_list args)
{
  va_list again;
  va_copy(again, args);
  const int length = vsnprintf(nullptr, 0, format, again);
  va_end(again);
  if (length < 0) {
    return fail(RCUTILS_RET_ERROR, "vsprintf on resized char array failed");
  }
  const size_t size = static_cast<size_t>(length) + 1;
  const rcutils_ret_t done = rcutils_char_array_expand_as_needed(array, size);
  if (done == RCUTILS_RET_OK) {
    vsnprintf(array->buffer, size, format, args);
    array->buffer_length = size;
  }
  return done;
}

rcutils_ret_t rcutils_string_array_init(rcutils_string_array_t * array, size_t size, const rcutils_allocator_t * allocator)
{
  const rcutils_ret_t done = init(array, allocator, rcutils_get_zero_initialized_string_array());
  if (done != RCUTILS_RET_OK || !size) {
    return done;
  }
  array->data = static_cast<char **>(allocator->zero_allocate(size, sizeof(char *), allocator->state));
  array->size = array->data ? size : 0;
  return array->data ? RCUTILS_RET_OK : fail(RCUTILS_RET_BAD_ALLOC, "failed to allocate string array");
}
rcutils_ret_t rcutils_string_array_fini(rcutils_string_array_t * array)
{
  if (array && !array->data) {
    return RCUTILS_RET_OK;
  }
  const rcutils_ret_t done = rcutils_string_array_resize(array, 0);
  if (done == RCUTILS_RET_OK) {
    *array = rcutils_get_zero_initialized_string_array();
  }
  return done;
}
rcutils_ret_t rcutils_string_array_resize(rcutils_string_array_t * array, size_t size)
{
  const rcutils_ret_t usable_ = usable(array);
  if (usable_ != RCUTILS_RET_OK || size == array->size) {
    return usable_;
  }
  const auto & from = array->allocator;
  const std::vector<char *> all(array->data, array->data + array->size);
  char ** data = nullptr;
  if (size) {
    data = static_cast<char **>(from.reallocate(array->data, size * sizeof(char *), from.state));
    if (!data) {
      return fail(RCUTILS_RET_BAD_ALLOC, "failed to allocate string array");
    }
  } else {
    from.deallocate(array->data, from.state);
  }
  for (size_t i = size; i < all.size(); ++i) {
    from.deallocate(all[i], from.state);
  }
  for (size_t i = all.size(); i < size; ++i) {
    data[i] = nullptr;
  }
  array->data = data;
  array->size = size;
  return RCUTILS_RET_OK;
}
rcutils_ret_t rcutils_string_array_cmp(
  const rcutils_string_array_t * left, const rcutils_string_array_t * right, int * order)
{
  if (!left || !right || !order) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "an argument is null");
  }
  for (size_t i = 0; i < left->size && i < right->size; ++i) {
    if (!left->data[i] || !right->data[i]) {
      return fail(RCUTILS_RET_ERROR, "a string of the arrays is null");
    }
    if ((*order = strcmp(left->data[i], right->data[i])) != 0) {
      return RCUTILS_RET_OK;
    }
  }
  *order = left->size < right->size ? -1 : left->size > right->size;
  return RCUTILS_RET_OK;
}
rcutils_ret_t rcutils_string_array_sort(rcutils_string_array_t * array)
{
  if (!array) {
    return fail(RCUTILS_RET_INVALID_ARGUMENT, "string_array is null");
  }
  std::sort(array->data, array->data + array->size, [](const char * one, const char * other) {
      return one && (!other || strcmp(one, other) < 0);
    });
  return RCUTILS_RET_OK;
}
