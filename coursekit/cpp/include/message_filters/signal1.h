// The callbacks of one filter.
#pragma once
#include "message_filters/signal.h"

namespace message_filters
{
/// A callback that was added, for its removal.
template<class M>
class CallbackHelper1
{
public:
  explicit CallbackHelper1(Connection connection)
  : connection_(std::move(connection)) {}
  void disconnect() {connection_.disconnect();}

private:
  Connection connection_;
};

template<class M>
class Signal1
{
public:
  using CallbackHelper1Ptr = std::shared_ptr<CallbackHelper1<M>>;
  template<typename P>
  CallbackHelper1Ptr addCallback(const std::function<void (P)> & callback)
  {
    return std::make_shared<CallbackHelper1<M>>(signal_.add(EventSignal<M>::of_types(callback)));
  }
  void removeCallback(const CallbackHelper1Ptr & helper) {helper->disconnect();}
  void call(const MessageEvent<M const> & event) {signal_.call(event);}

private:
  EventSignal<M> signal_;
};
}  // namespace message_filters
