// Threads on the virtual clock: each has its execution context in the session, one runs at a time, and who has to wait says so there.
#include <errno.h>
#include <pthread.h>

#include <algorithm>

#include "../threads.hpp"
#include "real.hpp"

namespace coursekit
{
namespace
{
struct Start
{
  void * (* function)(void *);
  void * argument;
  Connection connection;
};
void * begin(void * given)
{
  Start start = *static_cast<Start *>(given);
  delete static_cast<Start *>(given);
  use_connection(start.connection);
  begin_thread();
  return start.function(start.argument);
}
void * begin_in_pool(void * given)
{
  Start start = *static_cast<Start *>(given);
  delete static_cast<Start *>(given);
  t_in_pool = true;
  return start.function(start.argument);
}
int64_t number_of(pthread_t thread) {return (int64_t)thread;}  // NOLINT: a number on Linux, on a Mac a pointer
int wait_until(pthread_cond_t * c, pthread_mutex_t * m, int64_t left)
{
  pthread_mutex_unlock(m);
  bool woken = block(c, left < 0 ? -1 : g_state.steady + left);
  pthread_mutex_lock(m);
  return woken ? 0 : ETIMEDOUT;
}
}  // namespace

void start_real_thread(void * (*function)(void *), void * argument)
{
  static std::atomic<void *> known{nullptr};
  const auto create = real<decltype(&pthread_create)>(known, "pthread_create");
  pthread_t thread;
  if (create(&thread, nullptr, function, argument) == 0) {
    pthread_detach(thread);
  }
}
}  // namespace coursekit

extern "C" {
int pthread_create(
  pthread_t * __restrict thread, const pthread_attr_t * __restrict how, void * (*function)(void *), void * __restrict argument)
{
  COURSEKIT_REAL(pthread_create, thread, how, function, argument)
  if (coursekit::starts_pool(function, argument)) {
    return next(thread, how, coursekit::begin_in_pool, new coursekit::Start{function, argument, {}});
  }
  coursekit::Connection own = coursekit::connect_to_session(coursekit::THREAD);
  int error = next(thread, how, coursekit::begin, new coursekit::Start{function, argument, own});
  if (!error) {
    coursekit::request("thread", coursekit::Packer{}.i(coursekit::number_of(*thread)));
  }
  return error;
}
int pthread_join(pthread_t thread, void ** result)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_join, thread, result)
  coursekit::request("join", coursekit::Packer{}.i(coursekit::number_of(thread)));
  return next(thread, result);
}
int pthread_mutex_lock(pthread_mutex_t * m)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_mutex_lock, m)
  int error;
  while ((error = pthread_mutex_trylock(m)) == EBUSY) {
    coursekit::block(m, -1);
  }
  return error;
}
int pthread_mutex_unlock(pthread_mutex_t * m)
{
  static std::atomic<void *> known{nullptr};
  const auto next = coursekit::real<decltype(&pthread_mutex_unlock)>(known, "pthread_mutex_unlock");
  int error = next(m);
  if (!coursekit::t_in_pool) {
    coursekit::unblock(m, false);
  }
  return error;
}
int pthread_cond_wait(pthread_cond_t * __restrict c, pthread_mutex_t * __restrict m)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_cond_wait, c, m)
  coursekit::wait_until(c, m, -1);
  return 0;
}
int pthread_cond_timedwait(pthread_cond_t * __restrict c, pthread_mutex_t * __restrict m, const timespec * __restrict until)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_cond_timedwait, c, m, until)
  int64_t left = until->tv_sec * 1000000000LL + until->tv_nsec - coursekit::g_state.system;
  return coursekit::wait_until(c, m, std::max<int64_t>(left, 0));
}
#ifdef __GLIBC__  // libstdc++ waits by it for what has a steady clock
int pthread_cond_clockwait(
  pthread_cond_t * __restrict c, pthread_mutex_t * __restrict m, clockid_t id, const timespec * __restrict until)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_cond_clockwait, c, m, id, until)
  int64_t now = id == CLOCK_MONOTONIC ? coursekit::g_state.steady : coursekit::g_state.system;
  return coursekit::wait_until(c, m, std::max<int64_t>(until->tv_sec * 1000000000LL + until->tv_nsec - now, 0));
}
#endif
int pthread_cond_signal(pthread_cond_t * c)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_cond_signal, c)
  coursekit::unblock(c, false);
  return 0;
}
int pthread_cond_broadcast(pthread_cond_t * c)
{
  COURSEKIT_REAL_FOR_POOLS(pthread_cond_broadcast, c)
  coursekit::unblock(c, true);
  return 0;
}
}
