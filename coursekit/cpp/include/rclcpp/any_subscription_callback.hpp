// Calls whatever a program gives as callback: with the message, a pointer to it, or its bytes; with or without its info.
#pragma once
#include <functional>
#include <memory>

#include "rclcpp/intra_process.hpp"
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

/// Whether a callback only looks at the message, so that others may look at the same object.
template<class F, class M>
constexpr bool shares =
  std::is_invocable_v<F &, const M &> || std::is_invocable_v<F &, std::shared_ptr<const M>> ||
  std::is_invocable_v<F &, const M &, const MessageInfo &> ||
  std::is_invocable_v<F &, std::shared_ptr<const M>, const MessageInfo &>;

/// Call one that only looks.
template<class F, class M>
void call_with_shared(F & callback, const std::shared_ptr<const M> & message, const MessageInfo & info)
{
  if constexpr (std::is_invocable_v<F &, const M &>) {
    callback(*message);
  } else if constexpr (std::is_invocable_v<F &, std::shared_ptr<const M>>) {
    callback(message);
  } else if constexpr (std::is_invocable_v<F &, const M &, const MessageInfo &>) {
    callback(*message, info);
  } else {
    callback(message, info);
  }
}

/// Call `callback` with an object that stayed in the program; false where there is none for these bytes.
template<class M, class F>
bool call_with_kept(F & callback, intra_process::Inbox & inbox, const std::string & cdr, MessageInfo info)
{
  std::shared_ptr<void> box = inbox.take(cdr);
  if (!box) {
    return false;
  }
  info.get_rmw_message_info().from_intra_process = true;
  if constexpr (shares<F, M>) {
    call_with_shared<F, M>(callback, *std::static_pointer_cast<std::shared_ptr<const M>>(box), info);
  } else {
    call_with(callback, std::move(*std::static_pointer_cast<std::unique_ptr<M>>(box)), info);
  }
  return true;
}

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
