// Lists of texts and bytes in C: whoever makes one ends it with its `_fini`.
#pragma once
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "rcutils/logging.h"

typedef struct rcutils_string_array_t
{
  size_t size;
  char ** data;
  rcutils_allocator_t allocator;
} rcutils_string_array_t;
inline rcutils_string_array_t rcutils_get_zero_initialized_string_array() {return {0, nullptr, {}};}
rcutils_ret_t rcutils_string_array_init(rcutils_string_array_t * array, size_t size, const rcutils_allocator_t * allocator);
rcutils_ret_t rcutils_string_array_fini(rcutils_string_array_t * array);
/// Compare them text by text, as strcmp does; the shorter list comes first.
rcutils_ret_t rcutils_string_array_cmp(
  const rcutils_string_array_t * left, const rcutils_string_array_t * right, int * order);
/// New places have no text; what has no place any more is ended.
rcutils_ret_t rcutils_string_array_resize(rcutils_string_array_t * array, size_t size);
/// Places without a text come last.
rcutils_ret_t rcutils_string_array_sort(rcutils_string_array_t * array);

typedef struct rcutils_uint8_array_t
{
  uint8_t * buffer;
  size_t buffer_length, buffer_capacity;
  rcutils_allocator_t allocator = {};
} rcutils_uint8_array_t;
inline rcutils_uint8_array_t rcutils_get_zero_initialized_uint8_array() {return {nullptr, 0, 0};}
rcutils_ret_t rcutils_uint8_array_init(rcutils_uint8_array_t * array, size_t capacity, const rcutils_allocator_t * allocator);
rcutils_ret_t rcutils_uint8_array_resize(rcutils_uint8_array_t * array, size_t capacity);
rcutils_ret_t rcutils_uint8_array_fini(rcutils_uint8_array_t * array);

/// A text whose end, a zero, is kept and counted. The memory of one that does not own it is copied as it grows.
typedef struct rcutils_char_array_t
{
  char * buffer;
  bool owns_buffer;
  size_t buffer_length, buffer_capacity;
  rcutils_allocator_t allocator = {};
} rcutils_char_array_t;
inline rcutils_char_array_t rcutils_get_zero_initialized_char_array() {return {nullptr, true, 0, 0};}
rcutils_ret_t rcutils_char_array_init(rcutils_char_array_t * array, size_t capacity, const rcutils_allocator_t * allocator);
rcutils_ret_t rcutils_char_array_resize(rcutils_char_array_t * array, size_t capacity);
/// Let it grow where it has less.
rcutils_ret_t rcutils_char_array_expand_as_needed(rcutils_char_array_t * array, size_t capacity);
rcutils_ret_t rcutils_char_array_fini(rcutils_char_array_t * array);
/// Put a text behind what is there, or at most so many letters of it.
rcutils_ret_t rcutils_char_array_strcat(rcutils_char_array_t * array, const char * text);
rcutils_ret_t rcutils_char_array_strncat(rcutils_char_array_t * array, const char * text, size_t length);
/// Put a text in the place of what is there; letters without an end; what printf makes.
rcutils_ret_t rcutils_char_array_strcpy(rcutils_char_array_t * array, const char * text);
rcutils_ret_t rcutils_char_array_memcpy(rcutils_char_array_t * array, const char * letters, size_t count);
rcutils_ret_t rcutils_char_array_vsprintf(rcutils_char_array_t * array, const char * format, va_list args);
