// A value that threads share.
#pragma once
#include <mutex>

namespace realtime_tools
{
template<class T>
class RealtimeBox
{
public:
  explicit RealtimeBox(const T & initial = T())
  : thing_(initial) {}
  void set(const T & value)
  {
    std::lock_guard<std::mutex> hold(lock_);
    thing_ = value;
  }
  void get(T & ref)
  {
    std::lock_guard<std::mutex> hold(lock_);
    ref = thing_;
  }

private:
  T thing_;
  std::mutex lock_;
};
}  // namespace realtime_tools
