// What a callback takes of an event, by the type of its parameter.
#pragma once
#include "message_filters/message_event.h"

namespace message_filters
{
/// Of a parameter of type M or `const M &`.
template<typename M>
struct ParameterAdapter
{
  using Message = std::remove_const_t<std::remove_reference_t<M>>;
  using Event = MessageEvent<Message const>;
  using Parameter = M;
  static const Message & getParameter(const Event & event) {return *event.getMessage();}
};
template<typename M>
struct ParameterAdapter<std::shared_ptr<M const>>
{
  using Message = M;
  using Event = MessageEvent<Message const>;
  using Parameter = std::shared_ptr<M const>;
  static Parameter getParameter(const Event & event) {return event.getMessage();}
};
template<typename M>
struct ParameterAdapter<std::shared_ptr<M>>
{
  using Message = M;
  using Event = MessageEvent<Message const>;
  using Parameter = std::shared_ptr<M>;
  static Parameter getParameter(const Event & event) {return MessageEvent<Message>(event).getMessage();}
};
template<typename M>
struct ParameterAdapter<MessageEvent<M const>>
{
  using Message = M;
  using Event = MessageEvent<Message const>;
  using Parameter = const Event &;
  static Parameter getParameter(const Event & event) {return event;}
};
template<typename M>
struct ParameterAdapter<MessageEvent<M>>
{
  using Message = M;
  using Event = MessageEvent<Message const>;
  using Parameter = MessageEvent<M>;
  static Parameter getParameter(const Event & event) {return MessageEvent<Message>(event);}
};
template<typename M>
struct ParameterAdapter<const std::shared_ptr<M> &> : ParameterAdapter<std::shared_ptr<M>> {};
template<typename M>
struct ParameterAdapter<const MessageEvent<M> &> : ParameterAdapter<MessageEvent<M>> {};
}  // namespace message_filters
