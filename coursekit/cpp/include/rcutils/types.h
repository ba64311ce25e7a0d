// What C's functions return, and lists of texts and bytes in C: whoever makes one ends it with its `_fini`.
#pragma once
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "rcutils/logging.h"

#define RCUTILS_RET_WARN 1
#define RCUTILS_RET_BAD_ALLOC 10
#define RCUTILS_RET_NOT_ENOUGH_SPACE 12
#define RCUTILS_RET_NOT_INITIALIZED 13
#define RCUTILS_RET_NOT_FOUND 14
#define RCUTILS_RET_STRING_MAP_ALREADY_INIT 30
#define RCUTILS_RET_STRING_MAP_INVALID 31
#define RCUTILS_RET_STRING_KEY_NOT_FOUND 32

typedef struct rcutils_string_array_t
{
  size_t size;
  char ** data;
  rcutils_allocator_t allocator;
} rcutils_string_array_t;
inline rcutils_string_array_t rcutils_get_zero_initialized_string_array() {return {0, nullptr, {}};}
inline rcutils_ret_t rcutils_string_array_init(
  rcutils_string_array_t * array, size_t size, const rcutils_allocator_t * allocator)
{
  if (!array || !allocator) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  array->size = size;
  array->data = size ? static_cast<char **>(calloc(size, sizeof(char *))) : nullptr;
  return size && !array->data ? RCUTILS_RET_BAD_ALLOC : RCUTILS_RET_OK;
}
inline rcutils_ret_t rcutils_string_array_fini(rcutils_string_array_t * array)
{
  if (!array) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  for (size_t i = 0; i < array->size && array->data; ++i) {
    free(array->data[i]);
  }
  free(array->data);
  *array = rcutils_get_zero_initialized_string_array();
  return RCUTILS_RET_OK;
}
/// Compare them text by text, as strcmp does; the shorter list comes first.
inline rcutils_ret_t rcutils_string_array_cmp(
  const rcutils_string_array_t * left, const rcutils_string_array_t * right, int * order)
{
  if (!left || !right || !order) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  for (size_t i = 0; i < left->size && i < right->size; ++i) {
    if ((*order = strcmp(left->data[i], right->data[i])) != 0) {
      return RCUTILS_RET_OK;
    }
  }
  *order = left->size < right->size ? -1 : left->size > right->size;
  return RCUTILS_RET_OK;
}

typedef struct rcutils_uint8_array_t
{
  uint8_t * buffer;
  size_t buffer_length, buffer_capacity;
  rcutils_allocator_t allocator = {};
} rcutils_uint8_array_t;
typedef struct rcutils_char_array_t
{
  char * buffer;
  bool owns_buffer;
  size_t buffer_length, buffer_capacity;
  rcutils_allocator_t allocator = {};
} rcutils_char_array_t;

template<class Array>
rcutils_ret_t coursekit_array_resize(Array * array, size_t capacity)
{
  if (!array) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  if (capacity) {
    void * grown = realloc(array->buffer, capacity);
    if (!grown) {
      return RCUTILS_RET_BAD_ALLOC;
    }
    array->buffer = static_cast<decltype(array->buffer)>(grown);
  }
  array->buffer_capacity = capacity;
  array->buffer_length = array->buffer_length < capacity ? array->buffer_length : capacity;
  return RCUTILS_RET_OK;
}
template<class Array>
rcutils_ret_t coursekit_array_fini(Array * array)
{
  if (!array) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  free(array->buffer);
  array->buffer = nullptr;
  array->buffer_length = array->buffer_capacity = 0;
  return RCUTILS_RET_OK;
}
inline rcutils_uint8_array_t rcutils_get_zero_initialized_uint8_array() {return {nullptr, 0, 0};}
inline rcutils_ret_t rcutils_uint8_array_resize(rcutils_uint8_array_t * array, size_t capacity)
{
  return capacity ? coursekit_array_resize(array, capacity) : RCUTILS_RET_INVALID_ARGUMENT;
}
inline rcutils_ret_t rcutils_uint8_array_init(rcutils_uint8_array_t * array, size_t capacity, const rcutils_allocator_t *)
{
  *array = rcutils_get_zero_initialized_uint8_array();
  return coursekit_array_resize(array, capacity);
}
inline rcutils_ret_t rcutils_uint8_array_fini(rcutils_uint8_array_t * array) {return coursekit_array_fini(array);}
inline rcutils_char_array_t rcutils_get_zero_initialized_char_array() {return {nullptr, true, 0, 0};}
inline rcutils_ret_t rcutils_char_array_init(rcutils_char_array_t * array, size_t capacity, const rcutils_allocator_t *)
{
  rcutils_ret_t done = coursekit_array_resize(array, capacity);
  if (done == RCUTILS_RET_OK && capacity) {
    array->buffer[0] = '\0';
  }
  return done;
}
inline rcutils_ret_t rcutils_char_array_resize(rcutils_char_array_t * array, size_t capacity)
{
  return capacity ? coursekit_array_resize(array, capacity) : RCUTILS_RET_INVALID_ARGUMENT;
}
inline rcutils_ret_t rcutils_char_array_fini(rcutils_char_array_t * array) {return coursekit_array_fini(array);}
/// Put a text behind what is there; its end, a zero, is kept and counted.
inline rcutils_ret_t rcutils_char_array_strcat(rcutils_char_array_t * array, const char * text)
{
  size_t before = array->buffer ? strlen(array->buffer) : 0, length = before + strlen(text) + 1;
  if (length > array->buffer_capacity && rcutils_char_array_resize(array, length) != RCUTILS_RET_OK) {
    return RCUTILS_RET_BAD_ALLOC;
  }
  memcpy(array->buffer + before, text, strlen(text) + 1);
  array->buffer_length = length;
  return RCUTILS_RET_OK;
}
