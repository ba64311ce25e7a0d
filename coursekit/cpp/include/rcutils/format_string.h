// Texts as printf makes them, found and replaced, in C: the program frees what is new.
#pragma once
#include <stdarg.h>
#include <stdio.h>

#include "rcutils/strdup.h"

inline int rcutils_vsnprintf(char * buffer, size_t size, const char * format, va_list args)
{
  // only what has neither a place nor a size is merely measured
  return format && !buffer == !size ? vsnprintf(buffer, size, format, args) : -1;
}
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
inline int rcutils_snprintf(char * buffer, size_t size, const char * format, ...)
{
  va_list args;
  va_start(args, format);
  int length = rcutils_vsnprintf(buffer, size, format, args);
  va_end(args);
  return length;
}
#ifdef __GNUC__
__attribute__((format(printf, 3, 4)))
#endif
inline char * rcutils_format_string_limit(rcutils_allocator_t allocator, size_t limit, const char * format, ...)
{
  va_list args, again;
  va_start(args, format);
  va_copy(again, args);
  int length = rcutils_allocator_is_valid(&allocator) ? rcutils_vsnprintf(nullptr, 0, format, args) : -1;
  size_t size = length < 0 ? 0 : static_cast<size_t>(length) + 1 < limit ? static_cast<size_t>(length) + 1 : limit;
  char * made = size ? static_cast<char *>(allocator.allocate(size, allocator.state)) : nullptr;
  if (made) {
    rcutils_vsnprintf(made, size, format, again);
  }
  va_end(again);
  va_end(args);
  return made;
}
#define rcutils_format_string(allocator, ...) rcutils_format_string_limit(allocator, 2048, __VA_ARGS__)
