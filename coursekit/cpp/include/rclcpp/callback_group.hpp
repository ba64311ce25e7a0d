// Which callbacks may run beside each other.
#pragma once
#include <atomic>

#include "coursekit/entity.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
enum class CallbackGroupType {MutuallyExclusive, Reentrant};

class CallbackGroup : public coursekit::Entity
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(CallbackGroup)
  CallbackGroup(int64_t number, CallbackGroupType type, bool automatic = true)
  : type_(type), automatic_(automatic) {id = number;}
  const CallbackGroupType & type() const {return type_;}
  bool automatically_add_to_executor_with_node() const {return automatic_;}
  /// Whether an executor serves it by itself, apart from its node.
  std::atomic<bool> & get_associated_with_executor_atomic() {return in_executor_;}

private:
  CallbackGroupType type_;
  bool automatic_;
  std::atomic<bool> in_executor_{false};
};
}  // namespace rclcpp
