// The last few of what was put in; threads may share it.
#pragma once
#include <deque>
#include <mutex>
#include <stdexcept>
#include <utility>

#include "rclcpp/experimental/buffers/buffer_implementation_base.hpp"

namespace rclcpp::experimental::buffers
{
template<typename BufferT>
class RingBufferImplementation : public BufferImplementationBase<BufferT>
{
public:
  explicit RingBufferImplementation(size_t capacity)
  : capacity_(capacity)
  {
    if (capacity == 0) {
      throw std::invalid_argument("capacity must be a positive, non-zero value");
    }
  }
  /// Where it is full, the oldest goes.
  void enqueue(BufferT request) override
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (kept_.size() == capacity_) {
      kept_.pop_front();
    }
    kept_.push_back(std::move(request));
  }
  /// The oldest; an object of no value where there is none.
  BufferT dequeue() override
  {
    std::lock_guard<std::mutex> hold(lock_);
    if (kept_.empty()) {
      return BufferT();
    }
    BufferT oldest = std::move(kept_.front());
    kept_.pop_front();
    return oldest;
  }
  size_t next(size_t val) {return (val + 1) % capacity_;}
  bool has_data() const override
  {
    std::lock_guard<std::mutex> hold(lock_);
    return !kept_.empty();
  }
  bool is_full() const
  {
    std::lock_guard<std::mutex> hold(lock_);
    return kept_.size() == capacity_;
  }
  void clear() override
  {
    std::lock_guard<std::mutex> hold(lock_);
    kept_.clear();
  }

private:
  const size_t capacity_;
  mutable std::mutex lock_;
  std::deque<BufferT> kept_;
};
}  // namespace rclcpp::experimental::buffers
