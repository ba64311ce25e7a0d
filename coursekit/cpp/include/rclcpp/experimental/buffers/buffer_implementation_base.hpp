// What buffers of messages that stay in a program do.
#pragma once
#include <cstddef>

namespace rclcpp::experimental::buffers
{
template<typename BufferT>
class BufferImplementationBase
{
public:
  virtual ~BufferImplementationBase() = default;
  virtual BufferT dequeue() = 0;
  virtual void enqueue(BufferT request) = 0;
  virtual void clear() = 0;
  virtual bool has_data() const = 0;
};
}  // namespace rclcpp::experimental::buffers
