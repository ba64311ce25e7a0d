// Calls back in another thread when some time is over, unless it is cancelled before.
#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <utility>

namespace BT
{
class Alarm
{
public:
  explicit Alarm(std::function<void()> ring)
  : ring_(std::move(ring)) {}
  /// Waits for a call that is under way.
  ~Alarm();
  void set(std::chrono::milliseconds time);
  void cancel();
  /// Whether the time is over that was set.
  bool over() const;

private:
  using Clock = std::chrono::steady_clock;
  void run();

  std::function<void()> ring_;
  std::thread thread_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Clock::time_point when_ = Clock::time_point::max();
  bool waiting_ = false;
  bool ended_ = false;
};
}  // namespace BT
