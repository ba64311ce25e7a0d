// What the parts of the runtime share: the session's time and wishes, and the functions of the C library that they replace.
#pragma once
#include <dlfcn.h>
#include <time.h>

#include <atomic>
#include <cstdint>

#include "coursekit/link.hpp"

namespace coursekit
{
enum Flag {VIRTUAL = 1, STOPPING = 2, SIMULATED = 4};

/// The session's clock and flags as the last frame told them.
struct State
{
  std::atomic<int64_t> system{0}, steady{0}, flags{0};
  std::atomic<int> blocked{0};
  std::atomic<bool> is_virtual{false};
};
extern State g_state;

/// What the connections of threads are for; the first byte that goes up.
enum Purpose : char {MAIN = 'M', THREAD = 'T', WORKER = 'W', CONTROL = 'C'};
/// Connect to the session; ends the program where it cannot.
int connect_to_session(Purpose purpose);
/// Give the calling thread a connection that was made for it, before it asks anything.
void use_connection(int fd);
/// Wait until the session lets the calling thread begin.
void begin_thread();
/// Run what the session calls in this thread, until it closes the connection.
void serve_calls();
/// Start a thread past the replaced pthread_create: one that the session need not know of.
void start_real_thread(void * (*function)(void *), void * argument);

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
