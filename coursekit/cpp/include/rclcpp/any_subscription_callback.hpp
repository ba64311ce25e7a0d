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

/// Call `callback` with a message of T that others may have, too.
template<class T, class F>
void call_with_message(F & callback, const std::shared_ptr<const MessageOf<T>> & message, const MessageInfo & info)
{
  if constexpr (is_adapted<T> && takes<F, CustomOf<T>>) {
    auto custom = std::make_unique<CustomOf<T>>();
    Adapter<T>::convert_to_custom(*message, *custom);
    call_with(callback, std::move(custom), info);
  } else if constexpr (shares<F, MessageOf<T>>) {
    call_with_shared<F, MessageOf<T>>(callback, message, info);
  } else {
    call_with(callback, std::make_unique<MessageOf<T>>(*message), info);
  }
}
/// Call `callback` with a program's own object, or with the message of T that it stands for.
template<class T, class F>
void call_with_custom(F & callback, std::unique_ptr<CustomOf<T>> custom, const MessageInfo & info)
{
  if constexpr (takes<F, CustomOf<T>>) {
    call_with(callback, std::move(custom), info);
  } else {
    auto message = std::make_unique<MessageOf<T>>();
    Adapter<T>::convert_to_ros_message(*custom, *message);
    call_with(callback, std::move(message), info);
  }
}
/// Call `callback` with the bytes in a message that a strategy lends.
template<class T, class F, class Strategy>
void call_with_borrowed(F & callback, Strategy & strategy, const std::string & cdr, const MessageInfo & info)
{
  if constexpr (takes<F, MessageOf<T>> || takes<F, CustomOf<T>>) {
    std::shared_ptr<MessageOf<T>> message = strategy.borrow_message();
    coursekit::from_cdr(cdr, *message);
    call_with_message<T>(callback, message, info);
    strategy.return_message(message);
  } else {
    call_with_bytes<T>(callback, cdr, info);
  }
}

/// A subscription's callback of any form, chosen while the program runs.
template<class T, class Alloc = std::allocator<void>>
class AnySubscriptionCallback
{
  using Custom = CustomOf<T>;
  using Message = MessageOf<T>;

public:
  explicit AnySubscriptionCallback(const Alloc & = Alloc()) {}
  template<class F>
  AnySubscriptionCallback set(F given)
  {
    serialized_ = takes<F, SerializedMessage> && !takes<F, Message> && !takes<F, Custom>;
    shares_ = shares<F, Custom> || shares<F, Message>;
    auto callback = std::make_shared<F>(std::move(given));
    from_bytes_ = [callback](const std::string & cdr, const MessageInfo & info) {call_with_bytes<T>(*callback, cdr, info);};
    if constexpr (takes<F, Message> || takes<F, Custom>) {
      from_message_ = [callback](const std::shared_ptr<const Message> & message, const MessageInfo & info) {
          call_with_message<T>(*callback, message, info);
        };
      from_custom_ = [callback](std::unique_ptr<Custom> custom, const MessageInfo & info) {
          call_with_custom<T>(*callback, std::move(custom), info);
        };
      from_shared_ = [callback](const std::shared_ptr<const Custom> & custom, const MessageInfo & info) {
          if constexpr (shares<F, Custom>) {
            call_with_shared<F, Custom>(*callback, custom, info);
          } else {
            call_with_custom<T>(*callback, std::make_unique<Custom>(*custom), info);
          }
        };
    }
    return *this;
  }
  template<class F>
  AnySubscriptionCallback set_deprecated(F callback) {return set(std::move(callback));}

  void dispatch(std::shared_ptr<Message> message, const MessageInfo & info)
  {
    check("dispatch");
    from_message_(message, info);
  }
  void dispatch(std::shared_ptr<SerializedMessage> message, const MessageInfo & info)
  {
    if (!from_bytes_) {
      throw std::runtime_error("dispatch called on an unset AnySubscriptionCallback");
    }
    from_bytes_(message->bytes(), info);
  }
  void dispatch_intra_process(std::shared_ptr<const Custom> message, const MessageInfo & info)
  {
    check("dispatch_intra_process");
    from_shared_(message, info);
  }
  void dispatch_intra_process(std::unique_ptr<Custom> message, const MessageInfo & info)
  {
    check("dispatch_intra_process");
    from_custom_(std::move(message), info);
  }
  bool use_take_shared_method() const {return shares_;}
  bool is_serialized_message_callback() const {return serialized_;}
  void register_callback_for_tracing() {}

private:
  void check(const char * caller) const
  {
    if (!from_bytes_) {
      throw std::runtime_error(std::string(caller) + " called on an unset AnySubscriptionCallback");
    }
    if (serialized_) {
      throw std::runtime_error("Cannot dispatch std::shared_ptr<ROSMessageType> message to rclcpp::SerializedMessage");
    }
  }

  std::function<void (const std::string &, const MessageInfo &)> from_bytes_;
  std::function<void (const std::shared_ptr<const Message> &, const MessageInfo &)> from_message_;
  std::function<void (std::unique_ptr<Custom>, const MessageInfo &)> from_custom_;
  std::function<void (const std::shared_ptr<const Custom> &, const MessageInfo &)> from_shared_;
  bool shares_ = false, serialized_ = false;
};
}  // namespace rclcpp
