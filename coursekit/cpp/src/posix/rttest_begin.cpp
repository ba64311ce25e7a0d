// How a test of rttest begins: what it is told, and what memory and priority its thread asks Linux for.
#ifdef __linux__
#include <alloca.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include "rttest.hpp"
#include "rttest/utils.hpp"

namespace coursekit
{
namespace
{
std::mutex g_tests_lock;
std::map<pthread_t, RealTimeTest> g_tests;
pthread_t g_first_test = 0;

int begin(const rttest_params & params)
{
  std::lock_guard<std::mutex> lock(g_tests_lock);
  g_first_test = g_first_test ? g_first_test : pthread_self();
  RealTimeTest & test = g_tests[pthread_self()] = {};
  test.params = params;
  if (params.filename) {
    test.file = params.filename;
    test.params.filename = test.file.data();
    fprintf(stderr, "Writing results to file: %s\n", params.filename);
  }
  const size_t room = std::max<size_t>(params.iterations, 1);
  test.latencies.resize(room);
  test.minor.resize(room);
  test.major.resize(room);
  return 0;
}
/// A number before one of the units, each of which is `factor` of the next one.
uint64_t sized(const std::string & text, const std::vector<std::string> & units, double factor, uint64_t without)
{
  for (size_t i = 0; i < units.size(); ++i) {
    if (text.find(units[i]) != std::string::npos) {
      return static_cast<uint64_t>(std::stoull(text) * std::pow(factor, static_cast<double>(i)));
    }
  }
  return std::stoull(text) * without;
}
uint64_t bytes(const std::string & text)
{
  const bool plain = text.find_first_of("gmk") == std::string::npos && text.find('b') != std::string::npos;
  return plain ? std::stoull(text) : sized(text, {"kb", "mb", "gb"}, 1024, 1 << 10) << 10;
}
size_t policy_of(const std::string & word)
{
  if (word != "fifo" && word != "rr") {
    fprintf(stderr, "Invalid option entered for scheduling policy: %s\nValid options are: fifo, rr\n", word.c_str());
    exit(-1);
  }
  return word == "fifo" ? SCHED_FIFO : SCHED_RR;
}
void read_option(int letter, rttest_params & params)
{
  switch (letter) {
    case 'i': params.iterations = static_cast<size_t>(std::max(atoi(optarg), 0)); break;
    case 'u': uint64_to_timespec(sized(optarg, {"ns", "us", "ms", "s"}, 1000, 1000), &params.update_period); break;
    case 't': params.sched_priority = atoi(optarg); break;
    case 's': params.sched_policy = policy_of(optarg); break;
    case 'm': params.stack_size = bytes(optarg); break;
    case 'd': params.prefault_dynamic_size = bytes(optarg); break;
    case 'f': params.filename = optarg; break;
    default: fprintf(stderr, "Unknown option `-%c'.\n", optopt);
  }
}
}  // namespace

RealTimeTest * own_test()
{
  std::lock_guard<std::mutex> lock(g_tests_lock);
  auto found = g_tests.find(pthread_self());
  return found == g_tests.end() ? nullptr : &found->second;
}
void forget_own_test()
{
  std::lock_guard<std::mutex> lock(g_tests_lock);
  g_tests.erase(pthread_self());
}
}  // namespace coursekit

using coursekit::RealTimeTest;
using coursekit::own_test;

extern "C" {
int rttest_read_args(int argc, char ** argv)
{
  rttest_params params {1000, {0, 1000000}, SCHED_RR, 80, 1 << 20, uint64_t{8} << 30, nullptr};
  opterr = 0;
  optind = 1;
  for (int letter; (letter = getopt(argc, argv, "i:u:t:s:m:d:f:")) != -1; ) {
    coursekit::read_option(letter, params);
  }
  return coursekit::begin(params);
}
int rttest_init(
  size_t iterations, timespec update_period, size_t sched_policy, int sched_priority, size_t stack_size,
  uint64_t prefault_dynamic_size, char * filename)
{
  return coursekit::begin({iterations, update_period, sched_policy, sched_priority, stack_size, prefault_dynamic_size, filename});
}
int rttest_init_new_thread()
{
  std::unique_lock<std::mutex> lock(coursekit::g_tests_lock);
  auto first = coursekit::g_tests.find(coursekit::g_first_test);
  if (first == coursekit::g_tests.end() || coursekit::g_tests.count(pthread_self())) {
    return -1;
  }
  rttest_params params = first->second.params;
  lock.unlock();
  params.filename = nullptr;
  return coursekit::begin(params);
}
int rttest_get_params(rttest_params * params)
{
  RealTimeTest * test = own_test();
  if (!test || !params) {
    return -1;
  }
  *params = test->params;
  return 0;
}
int rttest_lock_memory() {return mlockall(MCL_CURRENT | MCL_FUTURE);}
int rttest_lock_and_prefault_dynamic()
{
  if (!own_test()) {
    return -1;
  }
  if (rttest_lock_memory() != 0) {
    perror("mlockall failed");
    return -1;
  }
  return 0;
}
int rttest_prefault_stack_size(const size_t stack_size)
{
  memset(alloca(stack_size), 0, stack_size);
  return 0;
}
int rttest_prefault_stack()
{
  RealTimeTest * test = own_test();
  return test ? rttest_prefault_stack_size(test->params.stack_size) : -1;
}
int rttest_set_sched_priority(const size_t sched_priority, const int policy)
{
  sched_param param {};
  param.sched_priority = static_cast<int>(sched_priority);
  return sched_setscheduler(0, policy, &param);
}
int rttest_set_thread_default_priority()
{
  RealTimeTest * test = own_test();
  const auto priority = test ? static_cast<size_t>(test->params.sched_priority) : 0;
  return test ? rttest_set_sched_priority(priority, static_cast<int>(test->params.sched_policy)) : -1;
}
int rttest_running() {return own_test() != nullptr;}
}
#endif
