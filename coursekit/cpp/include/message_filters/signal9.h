// The callbacks of a synchronizer of up to nine messages.
#pragma once
#include <tuple>

#include "message_filters/null_types.h"
#include "message_filters/signal.h"

namespace message_filters
{
namespace detail
{
/// Types without those that stand for no input.
template<class Done, class ... Left>
struct Real {using type = Done;};
template<class ... Done, class First, class ... Left>
struct Real<std::tuple<Done...>, First, Left...>
  : Real<std::conditional_t<std::is_same_v<First, NullType>, std::tuple<Done...>, std::tuple<Done..., First>>, Left...> {};
template<class Types>
struct SignalOf;
template<class ... M>
struct SignalOf<std::tuple<M...>> {using type = EventSignal<M...>;};
/// Nine types: those that there are, and NullType.
template<class Done, size_t left>
struct Filled;
template<class ... Done, size_t left>
struct Filled<std::tuple<Done...>, left> : Filled<std::tuple<Done..., NullType>, left - 1> {};
template<class ... Done>
struct Filled<std::tuple<Done...>, 0> {using type = std::tuple<Done...>;};
template<class Types>
struct EventsOf;
template<class ... M>
struct EventsOf<std::tuple<M...>> {using type = std::tuple<MessageEvent<M const>...>;};
}  // namespace detail

template<class ... M>
class Signal9
{
public:
  using RealTypes = typename detail::Real<std::tuple<>, M...>::type;
  static constexpr size_t COUNT = std::tuple_size_v<RealTypes>;
  using Messages = typename detail::Filled<RealTypes, 9 - COUNT>::type;
  using Events = typename detail::EventsOf<Messages>::type;

  template<typename ... P>
  Connection addCallback(const std::function<void (P...)> & callback)
  {
    return signal_.add(Signal::of_types(callback));
  }
  template<typename ... P>
  Connection addCallback(void (* callback)(P...)) {return addCallback(std::function<void (P...)>(callback));}
  template<typename T, typename ... P>
  Connection addCallback(void (T::* callback)(P...), T * object)
  {
    return addCallback(std::function<void (P...)>([callback, object](P ... p) {(object->*callback)(std::forward<P>(p)...);}));
  }
  template<typename T, typename ... P>
  Connection addCallback(void (T::* callback)(P...) const, const T * object)
  {
    return addCallback(std::function<void (P...)>([callback, object](P ... p) {(object->*callback)(std::forward<P>(p)...);}));
  }
  template<typename C>
  Connection addCallback(const C & callback) {return signal_.add(any(callback, static_cast<Messages *>(nullptr)));}
  /// Call with nine events; those of inputs that there are not are left out.
  template<class ... E>
  void call(const E & ... events) {call_first(std::forward_as_tuple(events ...), std::make_index_sequence<COUNT>());}

private:
  using Signal = typename detail::SignalOf<RealTypes>::type;
  template<class E, size_t ... i>
  void call_first(const E & events, std::index_sequence<i...>) {signal_.call(std::get<i>(events)...);}
  /// A callback that takes nine messages of any kind, or only those that there are.
  template<class C, class ... All>
  static typename Signal::Callback any(C callback, std::tuple<All...> *)
  {
    if constexpr (takes_nine<C, All...>()) {
      return [callback](const auto & ... events) mutable {
               nine(callback, std::forward_as_tuple(events ...), std::make_index_sequence<9>());
             };
    } else {
      return Signal::of_any(callback);
    }
  }
  template<class C, class ... All>
  static constexpr bool takes_nine()
  {
    return COUNT < 9 && !detail::TakesEvents<C>::value && !takes<C>(static_cast<RealTypes *>(nullptr)) && std::is_invocable_v<C &, const std::shared_ptr<All const> & ...>;
  }
  template<class C, class ... Some>
  static constexpr bool takes(std::tuple<Some...> *)
  {
    return std::is_invocable_v<C &, const std::shared_ptr<Some const> & ...>;
  }
  template<class C, class E, size_t ... i>
  static void nine(C & callback, const E & events, std::index_sequence<i...>) {callback(message<i>(events)...);}
  template<size_t i, class E>
  static std::shared_ptr<std::tuple_element_t<i, Messages> const> message(const E & events)
  {
    if constexpr (i < COUNT) {
      return std::get<i>(events).getConstMessage();
    } else {
      return nullptr;
    }
  }
  Signal signal_;
};
}  // namespace message_filters
