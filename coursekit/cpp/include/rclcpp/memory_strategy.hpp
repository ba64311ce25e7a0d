// Who makes what an executor needs. The session makes it: programs may say, and nothing else changes.
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
  explicit AllocatorMemoryStrategy(std::shared_ptr<Alloc> allocator)
  : allocator_(std::move(allocator)) {}
  std::shared_ptr<Alloc> get_allocator() const {return allocator_;}

private:
  std::shared_ptr<Alloc> allocator_ = std::make_shared<Alloc>();
};
}  // namespace memory_strategies::allocator_memory_strategy
namespace memory_strategies
{
inline memory_strategy::MemoryStrategy::SharedPtr create_default_strategy()
{
  return std::make_shared<allocator_memory_strategy::AllocatorMemoryStrategy<>>();
}
}  // namespace memory_strategies
}  // namespace rclcpp
