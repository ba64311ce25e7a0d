// This program, in C.
#pragma once
#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

#include "rcpputils/process.hpp"
#include "rcutils/strdup.h"

inline int rcutils_get_pid()
{
#ifdef _WIN32
  return _getpid();
#else
  return getpid();
#endif
}
/// The name of the file that runs, which the program frees.
inline char * rcutils_get_executable_name(rcutils_allocator_t allocator)
{
  return rcutils_strdup(rcpputils::get_executable_name().c_str(), allocator);
}
