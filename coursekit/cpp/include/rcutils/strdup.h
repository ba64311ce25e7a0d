// Copies of texts, in C: the program frees them.
#pragma once
#include <stdlib.h>
#include <string.h>

#include "rcutils/allocator.h"

inline char * rcutils_strndup(const char * text, size_t length, rcutils_allocator_t)
{
  char * copy = text ? static_cast<char *>(malloc(length + 1)) : nullptr;
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
