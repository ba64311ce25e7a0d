// What ends a tree's sleep early.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace BT
{
class WakeUpSignal
{
public:
  /// Whether it was woken before the time was over.
  bool waitFor(std::chrono::system_clock::duration time);
  void emitSignal();

private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool ready_ = false;
};
}  // namespace BT
