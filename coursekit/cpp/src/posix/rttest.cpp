// What a loop measures with rttest: how late it wakes, and its page faults by Linux's own counts. Nothing is late on the
// virtual clock.
#ifdef __linux__
#include <stdio.h>
#include <sys/mman.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <stdexcept>

#include "rttest.hpp"
#include "rttest/utils.hpp"

namespace coursekit
{
namespace
{
void count_faults(RealTimeTest & test, size_t i)
{
  const rusage before = test.before;
  getrusage(RUSAGE_THREAD, &test.before);
  test.major[i] = static_cast<size_t>(test.before.ru_majflt - before.ru_majflt);
  test.minor[i] = static_cast<size_t>(test.before.ru_minflt - before.ru_minflt);
}
void add_up(RealTimeTest & test, size_t i)
{
  const int64_t latency = test.latencies[test.turn(i)];
  rttest_results & sum = test.results;
  sum.iteration = i;
  sum.min_latency = test.measured ? std::min(sum.min_latency, latency) : latency;
  sum.max_latency = test.measured ? std::max(sum.max_latency, latency) : latency;
  sum.mean_latency += (static_cast<double>(latency) - sum.mean_latency) / static_cast<double>(i + 1);
  sum.minor_pagefaults += test.minor[test.turn(i)];
  sum.major_pagefaults += test.major[test.turn(i)];
  test.measured = true;
}
double deviation(const std::vector<int64_t> & of, double mean)
{
  double squares = 0;
  for (int64_t one : of) {
    squares += (static_cast<double>(one) - mean) * (static_cast<double>(one) - mean);
  }
  return std::sqrt(squares / static_cast<double>(of.size()));
}
void print(const RealTimeTest & test)
{
  const rttest_results & found = test.results;
  printf("rttest statistics%s%s:\n", test.file.empty() ? "" : " for ", test.file.c_str());
  printf("  - Minor pagefaults: %zu\n  - Major pagefaults: %zu\n", found.minor_pagefaults, found.major_pagefaults);
  printf("  Latency (time after deadline was missed):\n    - Min: %lld ns\n    - Max: %lld ns\n",
    static_cast<long long>(found.min_latency), static_cast<long long>(found.max_latency));  // NOLINT: printf's type
  printf("    - Mean: %f ns\n    - Standard deviation: %f\n\n\n", found.mean_latency, found.latency_stddev);
}
}  // namespace
}  // namespace coursekit

using coursekit::RealTimeTest;
using coursekit::own_test;

extern "C" {
int rttest_spin(void * (*user_function)(void *), void * args)
{
  RealTimeTest * test = own_test();
  return test ? rttest_spin_period(user_function, args, &test->params.update_period, test->params.iterations) : -1;
}
int rttest_spin_period(void * (*user_function)(void *), void * args, const timespec * update_period, const size_t iterations)
{
  if (!own_test()) {
    return -1;
  }
  timespec start;
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (size_t i = 0; own_test() && (iterations ? i < iterations : rttest_running()); ++i) {  // the function may end it
    if (rttest_spin_once_period(user_function, args, &start, update_period, i)) {
      throw std::runtime_error("error in spin_once");
    }
  }
  return 0;
}
int rttest_spin_once(void * (*user_function)(void *), void * args, const timespec * start_time, const size_t i)
{
  RealTimeTest * test = own_test();
  return test ? rttest_spin_once_period(user_function, args, start_time, &test->params.update_period, i) : -1;
}
int rttest_spin_once_period(
  void * (*user_function)(void *), void * args, const timespec * start_time, const timespec * update_period, const size_t i)
{
  RealTimeTest * test = own_test();
  if (!test || !start_time || !update_period || (test->params.iterations && i >= test->params.iterations)) {
    return -1;
  }
  if (i == 0) {
    getrusage(RUSAGE_THREAD, &test->before);
    printf("Initial major pagefaults: %ld\n", test->before.ru_majflt);
    printf("Initial minor pagefaults: %ld\n", test->before.ru_minflt);
  }
  const uint64_t due = timespec_to_uint64(start_time) + i * timespec_to_uint64(update_period);
  timespec wake, now;
  uint64_to_timespec(due, &wake);
  clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &wake, nullptr);
  clock_gettime(CLOCK_MONOTONIC, &now);
  test->latencies[test->turn(i)] = static_cast<int64_t>(timespec_to_uint64(&now) - due);
  user_function(args);
  if ((test = own_test())) {  // the function may have ended it
    coursekit::count_faults(*test, test->turn(i));
    coursekit::add_up(*test, i);
  }
  return 0;
}
int rttest_get_next_rusage(size_t i)
{
  RealTimeTest * test = own_test();
  if (!test || test->turn(i) >= test->minor.size()) {
    return -1;
  }
  coursekit::count_faults(*test, test->turn(i));
  return 0;
}
int rttest_calculate_statistics(rttest_results * results)
{
  RealTimeTest * test = own_test();
  if (!test || !results) {
    return -1;
  }
  auto & of = test->latencies;
  auto ends = std::minmax_element(of.begin(), of.end());
  results->min_latency = *ends.first;
  results->max_latency = *ends.second;
  results->mean_latency = std::accumulate(of.begin(), of.end(), 0.0) / static_cast<double>(of.size());
  results->latency_stddev = coursekit::deviation(of, results->mean_latency);
  results->minor_pagefaults = std::accumulate(test->minor.begin(), test->minor.end(), size_t{});
  results->major_pagefaults = std::accumulate(test->major.begin(), test->major.end(), size_t{});
  return 0;
}
int rttest_get_statistics(rttest_results * results)
{
  RealTimeTest * test = own_test();
  if (!test || !results || !test->measured) {
    return -1;
  }
  *results = test->results;
  return 0;
}
int rttest_clear_statistics()
{
  RealTimeTest * test = own_test();
  if (!test) {
    return -1;
  }
  for (auto * counts : {&test->minor, &test->major}) {
    std::fill(counts->begin(), counts->end(), 0);
  }
  std::fill(test->latencies.begin(), test->latencies.end(), 0);
  test->results = {};
  test->measured = false;
  return 0;
}
int rttest_get_sample_at(const size_t iteration, int64_t * sample)
{
  RealTimeTest * test = own_test();
  if (!test || !sample || test->turn(iteration) >= test->latencies.size()) {
    return -1;
  }
  *sample = test->latencies[test->turn(iteration)];
  return 0;
}
int rttest_write_results()
{
  RealTimeTest * test = own_test();
  return test ? rttest_write_results_file(test->params.filename) : -1;
}
int rttest_write_results_file(char * filename)
{
  RealTimeTest * test = own_test();
  if (!test || !test->params.iterations || !filename) {
    fprintf(stderr, "No %s, not writing results\n", filename ? "sample buffer was saved" : "results filename given");
    return -1;
  }
  std::ofstream file(filename);
  if (!file) {
    fprintf(stderr, "Couldn't open file %s, not writing results\n", filename);
    return -1;
  }
  file << "iteration timestamp latency minor_pagefaults major_pagefaults\n";
  for (size_t i = 0; i < test->latencies.size(); ++i) {
    file << i << " " << timespec_to_uint64(&test->params.update_period) * i << " " << test->latencies[i] << " " <<
      test->minor[i] << " " << test->major[i] << "\n";
  }
  return 0;
}
int rttest_finish()
{
  RealTimeTest * test = own_test();
  if (!test) {
    return -1;
  }
  munlockall();
  rttest_calculate_statistics(&test->results);
  coursekit::print(*test);
  coursekit::forget_own_test();
  return 0;
}
}
#endif
