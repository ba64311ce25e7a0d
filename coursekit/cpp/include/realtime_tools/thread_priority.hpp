// Threads that are served before others.
#pragma once
#ifdef __linux__
#include <sched.h>
#endif

#include <fstream>

namespace realtime_tools
{
/// Whether the kernel is one for real time.
inline bool has_realtime_kernel()
{
  std::ifstream file("/sys/kernel/realtime");
  bool is = false;
  return file && file >> is && is;
}
/// Give the calling thread a priority of the FIFO scheduler; false where the system does not allow it.
inline bool configure_sched_fifo(int priority)
{
#ifdef __linux__
  sched_param param{};
  param.sched_priority = priority;
  return sched_setscheduler(0, SCHED_FIFO, &param) == 0;
#else
  static_cast<void>(priority);
  return false;
#endif
}
}  // namespace realtime_tools
