// Filters: something that gives messages to the callbacks that are registered with it.
#pragma once
#include <string>

#include "message_filters/message_traits.h"
#include "message_filters/signal.h"
#include "rclcpp/rclcpp.hpp"

namespace message_filters
{
template<class M>
class SimpleFilter
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;
  SimpleFilter() = default;
  SimpleFilter(const SimpleFilter &) = delete;
  SimpleFilter & operator=(const SimpleFilter &) = delete;
  virtual ~SimpleFilter() = default;
  template<class C>
  Connection registerCallback(const C & callback) {return signal_.add(EventSignal<M>::of_any(callback));}
  template<class P>
  Connection registerCallback(const std::function<void (P)> & callback)
  {
    return signal_.add(EventSignal<M>::of_types(callback));
  }
  template<class P>
  Connection registerCallback(void (* callback)(P)) {return registerCallback(std::function<void (P)>(callback));}
  template<class T, class P>
  Connection registerCallback(void (T::* callback)(P), T * object)
  {
    return registerCallback(std::function<void (P)>([callback, object](P one) {(object->*callback)(std::forward<P>(one));}));
  }
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() {return name_;}

protected:
  void signalMessage(const MConstPtr & message) {signal_.call(EventType(message));}
  void signalMessage(const EventType & event) {signal_.call(event);}

private:
  EventSignal<M> signal_;
  std::string name_;
};
}  // namespace message_filters
