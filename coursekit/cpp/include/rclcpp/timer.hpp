// Timers.
#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>

#include "coursekit/entity.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class TimerBase : public coursekit::Entity, public std::enable_shared_from_this<TimerBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(TimerBase)
  void cancel() {ask("timer_cancel", Packer{}.i(id));}
  void reset() {ask("timer_reset", Packer{}.i(id));}
  bool is_canceled() {return ask("timer_canceled", Packer{}.i(id)).i();}
  bool is_ready() {return ask("timer_ready", Packer{}.i(id)).i();}
  bool is_steady() {return steady;}
  std::chrono::nanoseconds time_until_trigger() {return std::chrono::nanoseconds(ask("timer_left", Packer{}.i(id)).i());}
  bool call() {return ask("timer_call", Packer{}.i(id)).i();}
  void execute_callback() {callback();}
  std::shared_ptr<coursekit::Entity> get_timer_handle() {return shared_from_this();}
  std::shared_ptr<const coursekit::Entity> get_timer_handle() const {return shared_from_this();}
  bool exchange_in_use_by_wait_set_state(bool state) {return in_use_.exchange(state);}

  std::function<void ()> callback;
  bool steady = true;

private:
  std::atomic<bool> in_use_{false};
};
template<class F = std::function<void ()>, class = void>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)
};
template<class F = std::function<void ()>>
using WallTimer = GenericTimer<F>;
using VoidCallbackType = std::function<void ()>;
using TimerCallbackType = std::function<void (TimerBase &)>;
}  // namespace rclcpp
