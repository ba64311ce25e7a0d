// Where a subscription takes the messages from that it hands to its callback.
#pragma once
#include <memory>

#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/macros.hpp"
#include "rclcpp/serialized_message.hpp"

namespace rclcpp::message_memory_strategy
{
/// A new one for each, made by an allocator.
template<class M, class Alloc = std::allocator<void>>
class MessageMemoryStrategy
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessageMemoryStrategy)
  using MessageAllocTraits = allocator::AllocRebind<M, Alloc>;
  using MessageAlloc = typename MessageAllocTraits::allocator_type;
  using MessageDeleter = allocator::Deleter<MessageAlloc, M>;
  MessageMemoryStrategy() = default;
  explicit MessageMemoryStrategy(std::shared_ptr<Alloc> allocator)
  : message_allocator_(std::make_shared<MessageAlloc>(*allocator)) {}
  virtual ~MessageMemoryStrategy() = default;
  static SharedPtr create_default() {return std::make_shared<MessageMemoryStrategy<M, Alloc>>();}

  virtual std::shared_ptr<M> borrow_message() {return std::allocate_shared<M>(*message_allocator_);}
  virtual void return_message(std::shared_ptr<M> & message) {message.reset();}
  virtual std::shared_ptr<SerializedMessage> borrow_serialized_message(size_t capacity)
  {
    return std::make_shared<SerializedMessage>(capacity);
  }
  virtual std::shared_ptr<SerializedMessage> borrow_serialized_message()
  {
    return borrow_serialized_message(default_buffer_capacity_);
  }
  virtual void return_serialized_message(std::shared_ptr<SerializedMessage> & message) {message.reset();}
  virtual void set_default_buffer_capacity(size_t capacity) {default_buffer_capacity_ = capacity;}

  std::shared_ptr<MessageAlloc> message_allocator_ = std::make_shared<MessageAlloc>();
  size_t default_buffer_capacity_ = 0;
};
}  // namespace rclcpp::message_memory_strategy
