// Waiting on the virtual clock for another thread of the program: the session waits in this one's stead.
#include "state.hpp"
#include "threads.hpp"

namespace coursekit
{
namespace
{
int64_t address_of(const void * p) {return static_cast<int64_t>(reinterpret_cast<uintptr_t>(p));}
}  // namespace

bool block(const void * what, int64_t until)
{
  ++g_state.blocked;
  bool woken = request("block", Packer{}.i(address_of(what)).i(until)).i();
  --g_state.blocked;
  return woken;
}
void unblock(const void * what, bool all)
{
  if (g_state.is_virtual && g_state.blocked) {
    note("unblock", Packer{}.i(address_of(what)).i(all));
  }
}
}  // namespace coursekit
