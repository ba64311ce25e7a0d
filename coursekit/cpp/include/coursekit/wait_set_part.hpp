// What only one wait set may have at a time.
#pragma once
#include <atomic>

namespace coursekit
{
class WaitSetPart
{
public:
  /// Mark it as one of a wait set, or as one of none; whether it was one before.
  bool exchange_in_use_by_wait_set_state(bool in_use) {return in_use_.exchange(in_use);}

private:
  std::atomic<bool> in_use_{false};
};
}  // namespace coursekit
