// Callbacks by number; one may disconnect itself or others while it is called.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <type_traits>

#include "message_filters/connection.h"
#include "message_filters/parameter_adapter.h"

namespace message_filters
{
namespace detail
{
/// Whether a function object says that it takes events, which also come from messages, but not as they were received.
template<class C, class = void>
struct TakesEvents : std::false_type {};
template<class P>
struct IsEvent : std::false_type {};
template<class M>
struct IsEvent<MessageEvent<M>> : std::true_type {};
template<class R, class C, class ... P>
std::disjunction<IsEvent<std::decay_t<P>>...> takes_events(R (C::*)(P...) const);
template<class R, class C, class ... P>
std::disjunction<IsEvent<std::decay_t<P>>...> takes_events(R (C::*)(P...));
template<class C>
struct TakesEvents<C, std::void_t<decltype(&C::operator())>> : decltype(takes_events(&C::operator())) {};
}  // namespace detail

/// Calls with an event of each message. Where there are several callbacks, those that change a message change a copy.
template<class ... M>
class EventSignal
{
public:
  using Callback = std::function<void (const MessageEvent<M const> & ...)>;
  Connection add(Callback callback)
  {
    std::lock_guard<std::mutex> hold(state_->lock);
    const int number = state_->next++;
    state_->callbacks[number] = std::move(callback);
    std::weak_ptr<State> weak = state_;
    return Connection(
      [weak, number] {
        if (auto state = weak.lock()) {
          std::lock_guard<std::mutex> hold(state->lock);
          state->callbacks.erase(number);
        }
      });
  }
  void call(const MessageEvent<M const> & ... events)
  {
    std::map<int, Callback> now;
    {
      std::lock_guard<std::mutex> hold(state_->lock);
      now = state_->callbacks;
    }
    for (auto & entry : now) {
      entry.second(MessageEvent<M const>(events, now.size() > 1 || events.nonConstWillCopy())...);
    }
  }

  /// A callback with parameters of known types, in any of the forms that ParameterAdapter knows.
  template<class ... P>
  static Callback of_types(std::function<void (P...)> callback)
  {
    static_assert(sizeof...(P) == sizeof...(M), "the callback takes another number of messages");
    return [callback](const MessageEvent<M const> & ... events) {callback(ParameterAdapter<P>::getParameter(events)...);};
  }
  /// A callback whose parameters are not known: messages, or events where it does not take those.
  template<class C>
  static Callback of_any(C callback)
  {
    if constexpr (detail::TakesEvents<C>::value) {
      return of_types(std::function(callback));
    } else {
      return of_messages(callback);
    }
  }

private:
  template<class C>
  static Callback of_messages(C callback)
  {
    return [callback](const MessageEvent<M const> & ... events) mutable {
             if constexpr (std::is_invocable_v<C &, const std::shared_ptr<M const> & ...>) {
               callback(events.getConstMessage()...);
             } else if constexpr (std::is_invocable_v<C &, const std::shared_ptr<M> & ...>) {
               callback(MessageEvent<M>(events).getMessage()...);
             } else if constexpr (std::is_invocable_v<C &, const M & ...>) {
               callback(*events.getConstMessage()...);
             } else {
               callback(events ...);
             }
           };
  }
  struct State
  {
    std::mutex lock;
    std::map<int, Callback> callbacks;
    int next = 0;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};
}  // namespace message_filters
