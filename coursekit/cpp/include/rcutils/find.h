// Where a character stands in a text, in C; SIZE_MAX where it does not.
#pragma once
#include <stdint.h>
#include <string.h>

inline size_t rcutils_findn(const char * text, char delimiter, size_t length)
{
  const void * found = text ? memchr(text, delimiter, length) : nullptr;
  return found ? static_cast<size_t>(static_cast<const char *>(found) - text) : SIZE_MAX;
}
inline size_t rcutils_find(const char * text, char delimiter) {return text ? rcutils_findn(text, delimiter, strlen(text)) : SIZE_MAX;}
inline size_t rcutils_find_lastn(const char * text, char delimiter, size_t length)
{
  while (text && length) {
    if (text[--length] == delimiter) {
      return length;
    }
  }
  return SIZE_MAX;
}
inline size_t rcutils_find_last(const char * text, char delimiter)
{
  return text ? rcutils_find_lastn(text, delimiter, strlen(text)) : SIZE_MAX;
}
