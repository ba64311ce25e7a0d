// Timers.
#pragma once
#include <chrono>
#include <functional>
#include <optional>

#include "coursekit/entity.hpp"
#include "coursekit/wait_set_part.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/macros.hpp"

namespace rclcpp
{
class TimerBase
  : public coursekit::Entity, public coursekit::WaitSetPart, public std::enable_shared_from_this<TimerBase>
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
    if (every.count() < 0) {
      throw exceptions::RCLInvalidArgument("Couldn't initialize rcl timer handle: timer period must be non-negative");
    }
    if (by && by->get_clock_type() == RCL_CLOCK_UNINITIALIZED) {
      throw exceptions::RCLError("Couldn't initialize rcl timer handle: clock is not initialized");
    }
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
namespace detail
{
/// A timer's period; throws std::invalid_argument where it is negative or longer than nanoseconds can tell.
template<class Rep, class Period>
std::chrono::nanoseconds timer_period(std::chrono::duration<Rep, Period> period)
{
  using Span = std::chrono::duration<Rep, Period>;
  if (period < Span::zero()) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  if (std::chrono::duration<double, std::nano>(period) > std::chrono::nanoseconds::max() - Span(1)) {
    throw std::invalid_argument("timer period must be less than std::chrono::nanoseconds::max()");
  }
  return std::chrono::duration_cast<std::chrono::nanoseconds>(period);
}
}  // namespace detail
using VoidCallbackType = std::function<void ()>;
using TimerCallbackType = std::function<void (TimerBase &)>;
}  // namespace rclcpp
