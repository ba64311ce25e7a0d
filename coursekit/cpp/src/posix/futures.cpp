// std::future on the virtual clock: libstdc++ waits for it by functions of its own, past the mutexes of the C library.
#include <future>

#ifdef __GLIBCXX__
#include <bits/atomic_futex.h>

#include <algorithm>

#include "../threads.hpp"
#include "real.hpp"

namespace
{
using Wait = bool (*)(void *, unsigned *, unsigned, bool, std::chrono::seconds, std::chrono::nanoseconds);
using Notify = void (*)(unsigned *);

/// Wait while a number is what it was, until then (of that clock) where there is such a time.
bool wait_while(
  unsigned * number, unsigned value, bool has_end, std::chrono::seconds s, std::chrono::nanoseconds ns, int64_t now)
{
  int64_t left = has_end ? std::max<int64_t>((s + ns).count() - now, 0) : -1;
  int64_t until = left < 0 ? -1 : coursekit::g_state.steady + left;
  while (__atomic_load_n(number, __ATOMIC_ACQUIRE) == value) {
    if (!coursekit::block(number, until)) {
      return false;
    }
  }
  return true;
}
}  // namespace

namespace std
{
#define COURSEKIT_NEXT(type, name) \
  static std::atomic<void *> known{nullptr}; \
  const auto next = coursekit::real<type>(known, name)
#define COURSEKIT_DURATIONS "NSt6chrono8durationIlSt5ratioILl1ELl1EEEENS2_IlS3_ILl1ELl1000000000EEEE"

bool __atomic_futex_unsigned_base::_M_futex_wait_until(
  unsigned * number, unsigned value, bool has_end, chrono::seconds s, chrono::nanoseconds ns)
{
  COURSEKIT_NEXT(Wait, "_ZNSt28__atomic_futex_unsigned_base19_M_futex_wait_untilEPjjb" COURSEKIT_DURATIONS);
  if (!coursekit::g_state.is_virtual || coursekit::t_in_pool) {
    return next(this, number, value, has_end, s, ns);
  }
  return wait_while(number, value, has_end, s, ns, coursekit::g_state.system);
}
bool __atomic_futex_unsigned_base::_M_futex_wait_until_steady(
  unsigned * number, unsigned value, bool has_end, chrono::seconds s, chrono::nanoseconds ns)
{
  COURSEKIT_NEXT(Wait, "_ZNSt28__atomic_futex_unsigned_base26_M_futex_wait_until_steadyEPjjb" COURSEKIT_DURATIONS);
  if (!coursekit::g_state.is_virtual || coursekit::t_in_pool) {
    return next(this, number, value, has_end, s, ns);
  }
  return wait_while(number, value, has_end, s, ns, coursekit::g_state.steady);
}
void __atomic_futex_unsigned_base::_M_futex_notify_all(unsigned * number)
{
  COURSEKIT_NEXT(Notify, "_ZNSt28__atomic_futex_unsigned_base19_M_futex_notify_allEPj");
  next(number);
  if (!coursekit::t_in_pool) {
    coursekit::unblock(number, true);
  }
}
}  // namespace std
#endif
