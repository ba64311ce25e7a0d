// Texts compared without their cases, in C: 0 where it could be done, and what strcmp would say in `order`.
#pragma once
#include <stdint.h>

#include <cctype>

inline int rcutils_strncasecmp(const char * left, const char * right, size_t length, int * order)
{
  if (!left || !right || !order) {
    return -1;
  }
  auto letter = [](char c) {return std::tolower(static_cast<unsigned char>(c));};
  *order = 0;
  for (size_t i = 0; i < length && *order == 0; ++i) {
    *order = letter(left[i]) - letter(right[i]);
    if (!left[i]) {
      break;
    }
  }
  return 0;
}
inline int rcutils_strcasecmp(const char * left, const char * right, int * order)
{
  return rcutils_strncasecmp(left, right, SIZE_MAX, order);
}
