// Filters: something that gives messages to the callbacks that are registered with it.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "message_filters/message_traits.h"
#include "rclcpp/rclcpp.hpp"

namespace message_filters
{
/// A callback that is registered; it is called until this is disconnected.
class Connection
{
public:
  Connection() = default;
  explicit Connection(std::function<void ()> disconnect)
  : disconnect_(std::move(disconnect)) {}
  void disconnect()
  {
    if (auto now = std::move(disconnect_)) {
      disconnect_ = nullptr;
      now();
    }
  }

private:
  std::function<void ()> disconnect_;
};

/// A message as it came.
template<class M>
class MessageEvent
{
public:
  using ConstMessagePtr = std::shared_ptr<const M>;
  MessageEvent() = default;
  MessageEvent(const ConstMessagePtr & message, rclcpp::Time received = rclcpp::Clock().now())  // NOLINT: as Humble's
  : message_(message), received_(received) {}
  ConstMessagePtr getConstMessage() const {return message_;}
  const ConstMessagePtr & getMessage() const {return message_;}
  rclcpp::Time getReceiptTime() const {return received_;}

private:
  ConstMessagePtr message_;
  rclcpp::Time received_;
};

/// Callbacks by number; one may disconnect itself or others while it is called.
template<class ... A>
class Signal
{
public:
  using Callback = std::function<void (const A & ...)>;
  Connection add(Callback callback)
  {
    std::lock_guard<std::mutex> hold(state_->lock);
    int number = state_->next++;
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
  void call(const A & ... arguments)
  {
    std::map<int, Callback> now;
    {
      std::lock_guard<std::mutex> hold(state_->lock);
      now = state_->callbacks;
    }
    for (auto & entry : now) {
      entry.second(arguments ...);
    }
  }

private:
  struct State
  {
    std::mutex lock;
    std::map<int, Callback> callbacks;
    int next = 0;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

template<class M>
class SimpleFilter
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  using EventType = MessageEvent<M>;
  virtual ~SimpleFilter() = default;
  template<class C>
  Connection registerCallback(const C & callback)
  {
    return signal_.add(
      [callback](const EventType & event) {
        if constexpr (std::is_invocable_v<const C &, const MConstPtr &>) {
          callback(event.getMessage());
        } else if constexpr (std::is_invocable_v<const C &, const std::shared_ptr<M> &>) {
          callback(std::make_shared<M>(*event.getMessage()));  // whoever may change it gets one of its own
        } else if constexpr (std::is_invocable_v<const C &, const M &>) {
          callback(*event.getMessage());
        } else {
          callback(event);
        }
      });
  }
  template<class P>
  Connection registerCallback(void (* callback)(P))
  {
    return registerCallback(std::function<void (P)>(callback));
  }
  template<class T, class P>
  Connection registerCallback(void (T::* callback)(P), T * object)
  {
    return registerCallback(std::function<void (P)>([callback, object](P message) {(object->*callback)(message);}));
  }
  void setName(const std::string & name) {name_ = name;}
  const std::string & getName() {return name_;}

protected:
  void signalMessage(const MConstPtr & message) {signal_.call(EventType(message));}
  void signalMessage(const EventType & event) {signal_.call(event);}

private:
  Signal<EventType> signal_;
  std::string name_;
};

/// Passes on what it is given.
template<class M>
class PassThrough : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<const M>;
  PassThrough() = default;
  template<class F>
  explicit PassThrough(F & from) {connectInput(from);}
  template<class F>
  void connectInput(F & from)
  {
    connection_.disconnect();
    connection_ = from.registerCallback([this](const MConstPtr & message) {add(message);});
  }
  void add(const MConstPtr & message) {this->signalMessage(message);}
  void add(const MessageEvent<M> & event) {this->signalMessage(event);}

private:
  Connection connection_;
};
}  // namespace message_filters
