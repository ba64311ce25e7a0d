// Calls whatever a program gives as callback: with the message, a pointer to it, or its bytes; with or without its info.
#pragma once
#include <functional>
#include <memory>

#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"

namespace rclcpp
{
/// Call `callback` with a message in the form that it takes.
template<class F, class M>
void call_with(F & callback, std::unique_ptr<M> message, const MessageInfo & info)
{
  using Shared = std::shared_ptr<M>;
  using Unique = std::unique_ptr<M>;
  if constexpr (std::is_invocable_v<F &, const M &>) {
    callback(*message);
  } else if constexpr (std::is_invocable_v<F &, Shared>) {
    callback(Shared(std::move(message)));
  } else if constexpr (std::is_invocable_v<F &, Unique>) {
    callback(std::move(message));
  } else if constexpr (std::is_invocable_v<F &, const M &, const MessageInfo &>) {
    callback(*message, info);
  } else if constexpr (std::is_invocable_v<F &, Shared, const MessageInfo &>) {
    callback(Shared(std::move(message)), info);
  } else {
    static_assert(
      std::is_invocable_v<F &, Unique, const MessageInfo &>,
      "a subscription's callback takes the message: `const M &`, `M::SharedPtr`, `M::UniquePtr`, ...");
    callback(std::move(message), info);
  }
}

template<class F, class M>
constexpr bool takes =
  std::is_invocable_v<F &, const M &> || std::is_invocable_v<F &, std::shared_ptr<M>> ||
  std::is_invocable_v<F &, std::unique_ptr<M>> || std::is_invocable_v<F &, const M &, const MessageInfo &> ||
  std::is_invocable_v<F &, std::shared_ptr<M>, const MessageInfo &> ||
  std::is_invocable_v<F &, std::unique_ptr<M>, const MessageInfo &>;

/// Call `callback` with the bytes that came: as they are, as a message of T, or as the custom object it stands for.
template<class T, class F>
void call_with_bytes(F & callback, const std::string & cdr, const MessageInfo & info)
{
  if constexpr (takes<F, SerializedMessage> && !takes<F, MessageOf<T>> && !takes<F, CustomOf<T>>) {
    call_with(callback, std::make_unique<SerializedMessage>(cdr), info);
  } else {
    auto message = std::make_unique<MessageOf<T>>();
    coursekit::from_cdr(cdr, *message);
    if constexpr (is_adapted<T> && takes<F, CustomOf<T>>) {
      auto custom = std::make_unique<CustomOf<T>>();
      Adapter<T>::convert_to_custom(*message, *custom);
      call_with(callback, std::move(custom), info);
    } else {
      call_with(callback, std::move(message), info);
    }
  }
}
}  // namespace rclcpp
