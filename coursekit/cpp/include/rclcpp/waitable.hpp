// What a program makes itself for an executor or a wait set to wait for.
#pragma once
#include <functional>
#include <memory>
#include <stdexcept>

#include "coursekit/wait_set_part.hpp"
#include "rcl/wait.h"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class Waitable : public coursekit::WaitSetPart
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS_NOT_COPYABLE(Waitable)
  Waitable() = default;
  virtual ~Waitable() = default;
  virtual size_t get_number_of_ready_subscriptions() {return 0;}
  virtual size_t get_number_of_ready_timers() {return 0;}
  virtual size_t get_number_of_ready_clients() {return 0;}
  virtual size_t get_number_of_ready_events() {return 0;}
  virtual size_t get_number_of_ready_services() {return 0;}
  virtual size_t get_number_of_ready_guard_conditions() {return 0;}
  /// Add all that makes it ready.
  virtual void add_to_wait_set(rcl_wait_set_t * wait_set) = 0;
  /// Whether it is, by what a wait found.
  virtual bool is_ready(rcl_wait_set_t * wait_set) = 0;
  /// Take what execute() is to work on, so that it is not ready again at once.
  virtual std::shared_ptr<void> take_data() = 0;
  virtual std::shared_ptr<void> take_data_by_entity_id(size_t)
  {
    throw std::runtime_error("Custom waitables should override take_data_by_entity_id if they want to use it.");
  }
  virtual void execute(std::shared_ptr<void> & data) = 0;
  virtual void set_on_ready_callback(std::function<void (size_t, int)>)
  {
    throw std::runtime_error("Custom waitables should override set_on_ready_callback if they want to use it.");
  }
  virtual void clear_on_ready_callback()
  {
    throw std::runtime_error(
            "Custom waitables should override clear_on_ready_callback if they "
            "want to use it and make sure to call it on the waitable destructor.");
  }
};
}  // namespace rclcpp
