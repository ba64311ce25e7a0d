// Who makes what an executor and its subscriptions need. The session makes it: programs may say, and nothing else changes.
#pragma once
#include <memory>

namespace rclcpp
{
namespace memory_strategy
{
class MemoryStrategy
{
public:
  using SharedPtr = std::shared_ptr<MemoryStrategy>;
  virtual ~MemoryStrategy() = default;
};
}  // namespace memory_strategy
namespace memory_strategies::allocator_memory_strategy
{
template<class Alloc = std::allocator<void>>
class AllocatorMemoryStrategy : public memory_strategy::MemoryStrategy
{
public:
  using SharedPtr = std::shared_ptr<AllocatorMemoryStrategy<Alloc>>;
  AllocatorMemoryStrategy() = default;
  explicit AllocatorMemoryStrategy(std::shared_ptr<Alloc>) {}
};
}  // namespace memory_strategies::allocator_memory_strategy
namespace memory_strategies
{
inline memory_strategy::MemoryStrategy::SharedPtr create_default_strategy()
{
  return std::make_shared<allocator_memory_strategy::AllocatorMemoryStrategy<>>();
}
}  // namespace memory_strategies
namespace message_memory_strategy
{
template<class M, class Alloc = std::allocator<void>>
class MessageMemoryStrategy
{
public:
  using SharedPtr = std::shared_ptr<MessageMemoryStrategy<M, Alloc>>;
  MessageMemoryStrategy() = default;
  explicit MessageMemoryStrategy(std::shared_ptr<Alloc>) {}
  virtual ~MessageMemoryStrategy() = default;
  static SharedPtr create_default() {return std::make_shared<MessageMemoryStrategy<M, Alloc>>();}
};
}  // namespace message_memory_strategy
namespace strategies::message_pool_memory_strategy
{
template<class M, size_t Size>
class MessagePoolMemoryStrategy : public message_memory_strategy::MessageMemoryStrategy<M>
{
public:
  using SharedPtr = std::shared_ptr<MessagePoolMemoryStrategy<M, Size>>;
};
}  // namespace strategies::message_pool_memory_strategy
}  // namespace rclcpp
