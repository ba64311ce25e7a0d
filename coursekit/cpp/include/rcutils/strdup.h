// Copies of texts, in C: the program gives them back to the allocator.
#pragma once
#include <string.h>

#include "rcutils/allocator.h"

/// A copy of at most so many letters.
inline char * rcutils_strndup(const char * text, size_t length, rcutils_allocator_t allocator)
{
  length = text ? strnlen(text, length) : 0;
  char * copy = text ? static_cast<char *>(allocator.allocate(length + 1, allocator.state)) : nullptr;
  if (copy) {
    memcpy(copy, text, length);
    copy[length] = '\0';
  }
  return copy;
}
inline char * rcutils_strdup(const char * text, rcutils_allocator_t allocator)
{
  return text ? rcutils_strndup(text, strlen(text), allocator) : nullptr;
}
