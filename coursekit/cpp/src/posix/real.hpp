// The functions of the C library that ours hide.
#pragma once
#include <dlfcn.h>

#include "../state.hpp"

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

/// In a function that hides one of the C library: go on there unless time is virtual.
#define COURSEKIT_REAL(name, ...) \
  static std::atomic<void *> known{nullptr}; \
  const auto next = coursekit::real<decltype(&name)>(known, #name); \
  if (!coursekit::g_state.is_virtual) {return next(__VA_ARGS__);}
