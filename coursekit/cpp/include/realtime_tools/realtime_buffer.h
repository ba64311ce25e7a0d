// Hands a value from threads that may wait to one that must not.
#pragma once
#include <mutex>
#include <utility>

namespace realtime_tools
{
template<class T>
class RealtimeBuffer
{
public:
  RealtimeBuffer() = default;
  explicit RealtimeBuffer(const T & data)
  : realtime_(data), other_(data) {}
  RealtimeBuffer(const RealtimeBuffer & source) {*this = source;}
  RealtimeBuffer & operator=(const RealtimeBuffer & source)
  {
    if (this != &source) {
      std::lock_guard<std::mutex> hold(source.lock_);
      T copy = source.fresh_ ? source.other_ : source.realtime_;
      initRT(copy);
    }
    return *this;
  }
  /// Both sides have this value.
  void initRT(const T & data)
  {
    std::lock_guard<std::mutex> hold(lock_);
    realtime_ = other_ = data;
    fresh_ = false;
  }
  void writeFromNonRT(const T & data)
  {
    std::lock_guard<std::mutex> hold(lock_);
    other_ = data;
    fresh_ = true;
  }
  T * readFromNonRT() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    return fresh_ ? &other_ : &realtime_;
  }
  /// The newest value, or the last one while somebody writes.
  T * readFromRT()
  {
    std::unique_lock<std::mutex> hold(lock_, std::try_to_lock);
    if (hold.owns_lock() && fresh_) {
      std::swap(realtime_, other_);
      fresh_ = false;
    }
    return &realtime_;
  }
  void reset()
  {
    std::lock_guard<std::mutex> hold(lock_);
    fresh_ = false;
  }

private:
  mutable std::mutex lock_;
  mutable T realtime_{}, other_{};
  bool fresh_ = false;
};
}  // namespace realtime_tools
