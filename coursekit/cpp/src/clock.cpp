// The session's clock, and whether it has asked this program to end.
#include "state.hpp"

namespace coursekit
{
namespace
{
std::atomic<int> g_polls{0};
constexpr int POLLS_PER_TICK = 1000;
constexpr int64_t POLL_TICK_NS = 1000000;
}  // namespace

std::atomic<bool> g_stop{false};

bool stopping() {return g_stop || (g_state.flags & STOPPING);}
bool simulated_time() {return g_state.flags & SIMULATED;}
void poll()
{
  if (g_state.is_virtual && ++g_polls >= POLLS_PER_TICK) {
    g_polls = 0;
    sleep_for(POLL_TICK_NS);
  }
}
bool sleep_for(int64_t nanoseconds, int64_t context)
{
  g_polls = 0;
  return request("sleep", Packer{}.i(nanoseconds).i(context)).i() != 0;
}
int64_t system_now()
{
  poll();
  return g_state.is_virtual ? g_state.system.load() : real_system_ns();
}
int64_t steady_now()
{
  poll();
  return g_state.is_virtual ? g_state.steady.load() : real_steady_ns();
}
}  // namespace coursekit
