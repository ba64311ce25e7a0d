// Measures how late a loop wakes and how often its memory was not there: one test for each thread that begins one.
// All but rttest_running() give 0, or something else where it did not work.
#pragma once
#include <sched.h>
#include <stddef.h>
#include <stdint.h>
#include <time.h>

#ifdef __cplusplus
extern "C" {
#endif
struct rttest_params
{
  size_t iterations;
  struct timespec update_period;
  size_t sched_policy;
  int sched_priority;
  size_t stack_size;
  uint64_t prefault_dynamic_size;
  char * filename;
};
/// Times in nanoseconds, of all turns up to `iteration`.
struct rttest_results
{
  size_t iteration;
  int64_t min_latency;
  int64_t max_latency;
  double mean_latency;
  double latency_stddev;
  size_t minor_pagefaults;
  size_t major_pagefaults;
};

/// Begin with the options of a command line: -i turns, -u period, -t priority, -s fifo or rr, -m stack, -d heap, -f file.
int rttest_read_args(int argc, char ** argv);
int rttest_init(
  size_t iterations, struct timespec update_period, size_t sched_policy, int sched_priority, size_t stack_size,
  uint64_t prefault_dynamic_size, char * filename);
/// Begin in one more thread with what the first was told.
int rttest_init_new_thread();
int rttest_get_params(struct rttest_params * params);

/// Call a function each period; without end where the number of turns is 0, until rttest_finish().
int rttest_spin(void * (*user_function)(void *), void * args);
int rttest_spin_period(
  void * (*user_function)(void *), void * args, const struct timespec * update_period, const size_t iterations);
int rttest_spin_once(void * (*user_function)(void *), void * args, const struct timespec * start_time, const size_t i);
int rttest_spin_once_period(
  void * (*user_function)(void *), void * args, const struct timespec * start_time, const struct timespec * update_period,
  const size_t i);

int rttest_lock_memory();
/// Lock what the program has. Nothing more is taken beforehand: upstream takes 8 GB, and a student's computer is shared.
int rttest_lock_and_prefault_dynamic();
int rttest_prefault_stack();
int rttest_prefault_stack_size(const size_t stack_size);
int rttest_set_sched_priority(const size_t sched_priority, const int policy);
int rttest_set_thread_default_priority();

int rttest_get_next_rusage(size_t i);
int rttest_calculate_statistics(struct rttest_results * results);
int rttest_get_statistics(struct rttest_results * results);
int rttest_clear_statistics();
int rttest_get_sample_at(const size_t iteration, int64_t * sample);
int rttest_write_results();
int rttest_write_results_file(char * filename);
/// End the thread's test and print what it measured.
int rttest_finish();
int rttest_running();
#ifdef __cplusplus
}
#endif
