// The functions of the C library that ours hide.
#pragma once
#include <dlfcn.h>

#include "../state.hpp"
#include "pools.hpp"

namespace coursekit
{
/// The function of the C library that one of ours hides; `known` is a static with a constant value, since the guard of any
/// other static would lock a mutex, which is one of the functions that are hidden.
template<class F>
F real(std::atomic<void *> & known, const char * name)
{
  if (!known) {
    known = dlsym(RTLD_NEXT, name);
  }
  return reinterpret_cast<F>(known.load());
}
}  // namespace coursekit

/// In a function that hides one of the C library: go on there unless the calling thread is on the virtual clock.
#define COURSEKIT_REAL(name, ...) \
  static std::atomic<void *> known{nullptr}; \
  const auto next = coursekit::real<decltype(&name)>(known, #name); \
  if (!coursekit::g_state.is_virtual || coursekit::t_in_pool) {return next(__VA_ARGS__);}
/// The same, and go on there too for a library that waits for threads of its own.
#define COURSEKIT_REAL_FOR_POOLS(name, ...) \
  COURSEKIT_REAL(name, __VA_ARGS__) \
  if (coursekit::is_of_pool(__builtin_return_address(0))) {return next(__VA_ARGS__);}
