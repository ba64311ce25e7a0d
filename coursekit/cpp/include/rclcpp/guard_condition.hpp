// Flags that a program raises to end a wait.
#pragma once
#include <functional>
#include <mutex>

#include "coursekit/entity.hpp"
#include "coursekit/wait_set_part.hpp"
#include "rclcpp/utilities.hpp"

struct rcl_wait_set_t;

namespace rclcpp
{
class GuardCondition : public coursekit::Entity, public coursekit::WaitSetPart
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GuardCondition)
  explicit GuardCondition(Context::SharedPtr context = contexts::get_global_default_context())
  : context_(std::move(context))
  {
    if (!context_) {
      throw std::invalid_argument("context argument unexpectedly nullptr");
    }
    id = ask("guard_condition").i();
  }
  Context::SharedPtr get_context() const {return context_;}
  void trigger()
  {
    coursekit::note("trigger", Packer{}.i(id));
    std::lock_guard<std::recursive_mutex> hold(lock_);
    if (on_trigger_) {
      on_trigger_(1);
    } else {
      ++untold_;
    }
  }
  void set_on_trigger_callback(std::function<void (size_t)> callback)
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    on_trigger_ = std::move(callback);
    if (on_trigger_ && untold_) {
      on_trigger_(std::exchange(untold_, 0));
    }
  }
  coursekit::Entity & get_rcl_guard_condition() {return *this;}
  const coursekit::Entity & get_rcl_guard_condition() const {return *this;}
  void add_to_wait_set(rcl_wait_set_t * wait_set);

private:
  Context::SharedPtr context_;
  std::recursive_mutex lock_;
  std::function<void (size_t)> on_trigger_;
  size_t untold_ = 0;
  bool in_waitable_ = false;
};
}  // namespace rclcpp
