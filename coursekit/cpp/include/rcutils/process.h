// This program, in C.
#pragma once
#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

#include "rcutils/allocator.h"

inline int rcutils_get_pid()
{
#ifdef _WIN32
  return _getpid();
#else
  return getpid();
#endif
}
/// The name of the file that runs, which the program gives back to the allocator; null where the system does not say.
char * rcutils_get_executable_name(rcutils_allocator_t allocator);
