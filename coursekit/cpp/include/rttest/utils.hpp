// Sums and differences of C's times.
#pragma once
#include <stdint.h>
#include <time.h>

#define NSEC_PER_SEC 1000000000

static inline uint64_t timespec_to_uint64(const struct timespec * t)
{
  return static_cast<uint64_t>(t->tv_sec) * NSEC_PER_SEC + static_cast<uint64_t>(t->tv_nsec);
}
static inline void uint64_to_timespec(const uint64_t input, struct timespec * t)
{
  t->tv_sec = static_cast<time_t>(input / NSEC_PER_SEC);
  t->tv_nsec = static_cast<long>(input % NSEC_PER_SEC);  // NOLINT: timespec's own type
}
static inline void normalize_timespec(struct timespec * t) {uint64_to_timespec(timespec_to_uint64(t), t);}
static inline bool timespec_gt(const struct timespec * t1, const struct timespec * t2)
{
  return timespec_to_uint64(t1) > timespec_to_uint64(t2);
}
static inline void add_timespecs(const struct timespec * t1, const struct timespec * t2, struct timespec * dst)
{
  uint64_to_timespec(timespec_to_uint64(t1) + timespec_to_uint64(t2), dst);
}
/// How far they are apart, whichever is later.
static inline bool subtract_timespecs(const struct timespec * t1, const struct timespec * t2, struct timespec * dst)
{
  uint64_t a = timespec_to_uint64(t1), b = timespec_to_uint64(t2);
  uint64_to_timespec(a > b ? a - b : b - a, dst);
  return true;
}
static inline void multiply_timespec(const struct timespec * t, const uint32_t i, struct timespec * result)
{
  uint64_to_timespec(i * timespec_to_uint64(t), result);
}
