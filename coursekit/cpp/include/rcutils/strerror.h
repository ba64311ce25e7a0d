// The last error of the system in words, in C.
#pragma once
#include <stdio.h>

#include <cerrno>
#include <system_error>

inline void rcutils_strerror(char * buffer, size_t size)
{
  snprintf(buffer, size, "%s", std::generic_category().message(errno).c_str());
}
