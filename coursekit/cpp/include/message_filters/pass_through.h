// Passes on what it is given.
#pragma once
#include "message_filters/simple_filter.h"

namespace message_filters
{
template<class M>
class PassThrough : public SimpleFilter<M>
{
public:
  using MConstPtr = std::shared_ptr<M const>;
  using EventType = MessageEvent<M const>;
  PassThrough() = default;
  template<class F>
  explicit PassThrough(F & from) {connectInput(from);}
  template<class F>
  void connectInput(F & from)
  {
    connection_.disconnect();
    connection_ = from.registerCallback(std::function<void (const EventType &)>([this](const EventType & event) {add(event);}));
  }
  void add(const MConstPtr & message) {this->signalMessage(message);}
  void add(const EventType & event) {this->signalMessage(event);}

private:
  Connection connection_;
};
}  // namespace message_filters
