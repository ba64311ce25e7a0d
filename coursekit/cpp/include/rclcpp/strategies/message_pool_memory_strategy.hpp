// Messages that are used again and again: nothing is allocated while a program runs.
#pragma once
#include <array>
#include <stdexcept>

#include "rclcpp/message_memory_strategy.hpp"

namespace rclcpp::strategies::message_pool_memory_strategy
{
template<class M, size_t Size, class = void>
class MessagePoolMemoryStrategy : public message_memory_strategy::MessageMemoryStrategy<M>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(MessagePoolMemoryStrategy)
  /// The next of the pool, as good as new; std::runtime_error where that one has not come back.
  std::shared_ptr<M> borrow_message() override
  {
    Place & place = pool_[next_++ % Size];
    if (place.is_lent) {
      throw std::runtime_error("Tried to access message that was still in use! Abort.");
    }
    *place.message = M();
    place.is_lent = true;
    return place.message;
  }
  void return_message(std::shared_ptr<M> & message) override
  {
    for (Place & place : pool_) {
      if (place.message == message) {
        place.is_lent = false;
        return;
      }
    }
    throw std::runtime_error("Unrecognized message ptr in return_message.");
  }

private:
  struct Place
  {
    std::shared_ptr<M> message = std::make_shared<M>();
    bool is_lent = false;
  };
  std::array<Place, Size> pool_;
  size_t next_ = 0;
};
}  // namespace rclcpp::strategies::message_pool_memory_strategy
