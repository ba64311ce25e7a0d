// The C library's clocks and sleeps on the session's clock while that is virtual, and Ctrl-C.
#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include "real.hpp"

namespace coursekit
{
namespace
{
void on_signal(int) {g_stop = true;}

int real_clock(clockid_t id, timespec * t)
{
  static std::atomic<void *> known{nullptr};
  const auto next = real<int (*)(clockid_t, timespec *)>(known, "clock_gettime");
  return next(id, t);
}
int64_t real_ns(clockid_t id)
{
  timespec t;
  real_clock(id, &t);
  return t.tv_sec * 1000000000LL + t.tv_nsec;
}
timespec timespec_of(int64_t ns)
{
  timespec t;
  t.tv_sec = static_cast<time_t>(ns / 1000000000);
  t.tv_nsec = static_cast<long>(ns % 1000000000);  // NOLINT: timespec's own type
  return t;
}
void react_to(int signal, void (* handler)(int))
{
  struct sigaction action {};
  action.sa_handler = handler;
  sigaction(signal, &action, nullptr);
}
}  // namespace

void catch_signals(bool interrupt, bool terminate)
{
  if (interrupt) {
    react_to(SIGINT, on_signal);
  }
  if (terminate) {
    react_to(SIGTERM, on_signal);
  }
}
void release_signals()
{
  react_to(SIGINT, SIG_DFL);
  react_to(SIGTERM, SIG_DFL);
}
void obey_signal(int number) {raise(number);}
int64_t real_system_ns() {return real_ns(CLOCK_REALTIME);}
int64_t real_steady_ns() {return real_ns(CLOCK_MONOTONIC);}
}  // namespace coursekit

extern "C" {
int clock_gettime(clockid_t id, timespec * t)
{
  bool of_cpu = id == CLOCK_PROCESS_CPUTIME_ID || id == CLOCK_THREAD_CPUTIME_ID || static_cast<int>(id) < 0;  // some thread's
  if (!coursekit::g_state.is_virtual || coursekit::t_in_pool || of_cpu) {
    return coursekit::real_clock(id, t);
  }
#ifdef CLOCK_REALTIME_COARSE
  bool of_day = id == CLOCK_REALTIME || id == CLOCK_REALTIME_COARSE;
#else
  bool of_day = id == CLOCK_REALTIME;
#endif
  *t = coursekit::timespec_of(of_day ? coursekit::system_now() : coursekit::steady_now());
  return 0;
}
int gettimeofday(timeval * __restrict t, void * __restrict)
{
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  t->tv_sec = now.tv_sec;
  t->tv_usec = static_cast<suseconds_t>(now.tv_nsec / 1000);
  return 0;
}
time_t time(time_t * t)
{
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (t) {
    *t = now.tv_sec;
  }
  return now.tv_sec;
}
int nanosleep(const timespec * wish, timespec * left)
{
  COURSEKIT_REAL(nanosleep, wish, left)
  coursekit::sleep_for(wish->tv_sec * 1000000000LL + wish->tv_nsec);
  if (left) {
    *left = {0, 0};
  }
  return 0;
}
#ifdef TIMER_ABSTIME  // macOS has none
int clock_nanosleep(clockid_t id, int flags, const timespec * wish, timespec * left)
{
  COURSEKIT_REAL(clock_nanosleep, id, flags, wish, left)
  int64_t ns = wish->tv_sec * 1000000000LL + wish->tv_nsec;
  if (flags & TIMER_ABSTIME) {
    ns -= id == CLOCK_REALTIME ? coursekit::g_state.system.load() : coursekit::g_state.steady.load();
  }
  if (ns > 0) {
    coursekit::sleep_for(ns);
  }
  return 0;
}
#endif
int usleep(useconds_t us)
{
  timespec t = coursekit::timespec_of(us * 1000LL);
  return nanosleep(&t, nullptr);
}
unsigned sleep(unsigned seconds)
{
  timespec t = coursekit::timespec_of(seconds * 1000000000LL);
  nanosleep(&t, nullptr);
  return 0;
}
}
