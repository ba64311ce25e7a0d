// Timers.
#pragma once
#include <atomic>
#include <chrono>
#include <functional>
#include <optional>

#include "coursekit/entity.hpp"
#include "rclcpp/clock.hpp"
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

  /// Have a function called when the timer rings, with the timer where it takes one.
  template<class F>
  void call_back(F given)
  {
    auto kept = std::make_shared<F>(std::move(given));  // it may be one that cannot be copied
    if constexpr (std::is_invocable_v<F &>) {
      callback = [kept] {(*kept)();};
    } else {
      static_assert(std::is_invocable_v<F &, TimerBase &>, "a timer's callback takes nothing, or `rclcpp::TimerBase &`");
      callback = [kept, this] {(*kept)(*this);};
    }
  }
  std::function<void ()> callback;
  bool steady = true;
  std::chrono::nanoseconds period{0};
  /// The clock that it rings by; null for a steady one of the session's.
  Clock::SharedPtr clock;

private:
  std::atomic<bool> in_use_{false};
};
/// A timer that rings from when a node has it: by create_timer(), or by add_timer() of a node's interface.
template<class F = std::function<void ()>, class = void>
class GenericTimer : public TimerBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericTimer)
  GenericTimer(
    Clock::SharedPtr by, std::chrono::nanoseconds every, F && then,
    Context::SharedPtr = contexts::get_global_default_context())
  {
    clock = std::move(by);
    period = every;
    call_back<F>(std::move(then));
  }
};
template<class F = std::function<void ()>, class = void>
class WallTimer : public GenericTimer<F>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(WallTimer)
  WallTimer(std::chrono::nanoseconds every, F && then, Context::SharedPtr = contexts::get_global_default_context())
  : GenericTimer<F>(nullptr, every, std::move(then)) {}
};
using VoidCallbackType = std::function<void ()>;
using TimerCallbackType = std::function<void (TimerBase &)>;
}  // namespace rclcpp
