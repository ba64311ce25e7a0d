// A test of rttest: what a thread's loop has measured.
#pragma once
#include <pthread.h>
#include <sys/resource.h>

#include <string>
#include <vector>

#include "rttest/rttest.h"

namespace coursekit
{
struct RealTimeTest
{
  rttest_params params {};
  rttest_results results {};
  std::vector<int64_t> latencies;
  std::vector<size_t> minor, major;
  std::string file;
  rusage before {};
  bool measured = false;
  size_t turn(size_t i) const {return params.iterations ? i : 0;}  // without end only the last turn is kept
};
/// The calling thread's, null where it has none.
RealTimeTest * own_test();
void forget_own_test();
}  // namespace coursekit
