// Libraries that a program loads while it runs, in C.
#pragma once
#include "rcutils/allocator.h"
#include "rcutils/types.h"

typedef struct rcutils_shared_library_t
{
  void * lib_pointer;
  char * library_path;
  rcutils_allocator_t allocator;
} rcutils_shared_library_t;
inline rcutils_shared_library_t rcutils_get_zero_initialized_shared_library() {return {nullptr, nullptr, {}};}
inline bool rcutils_is_shared_library_loaded(rcutils_shared_library_t * library) {return library && library->lib_pointer;}
rcutils_ret_t rcutils_load_shared_library(
  rcutils_shared_library_t * library, const char * path, rcutils_allocator_t allocator);
void * rcutils_get_symbol(const rcutils_shared_library_t * library, const char * name);
bool rcutils_has_symbol(const rcutils_shared_library_t * library, const char * name);
rcutils_ret_t rcutils_unload_shared_library(rcutils_shared_library_t * library);
/// Write a library's file name on this system into a buffer.
rcutils_ret_t rcutils_get_platform_library_name(const char * name, char * buffer, unsigned int size, bool debug);
