// A part of a text for another, in C: the program gives the new text back to the allocator.
#pragma once
#include <string>

#include "rcutils/strdup.h"

inline char * rcutils_repl_str(const char * text, const char * from, const char * to, const rcutils_allocator_t * allocator)
{
  std::string made = text;
  const std::string part = from, other = to;
  for (size_t at = 0; !part.empty() && (at = made.find(part, at)) != made.npos; at += other.size()) {
    made.replace(at, part.size(), other);
  }
  return rcutils_strdup(made.c_str(), *allocator);
}
