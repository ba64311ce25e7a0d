// A part of a text for another, in C: the program gives the new text back to the allocator.
#pragma once
#include "rcpputils/find_and_replace.hpp"
#include "rcutils/strdup.h"

inline char * rcutils_repl_str(const char * text, const char * from, const char * to, const rcutils_allocator_t * allocator)
{
  return rcutils_strdup(rcpputils::find_and_replace(text, from, to).c_str(), *allocator);
}
