// A message as it came: of type M, or const M for those that only read it.
#pragma once
#include <functional>
#include <memory>
#include <type_traits>
#include <utility>

#include "rclcpp/clock.hpp"
#include "rclcpp/time.hpp"

namespace message_filters
{
template<typename M>
struct DefaultMessageCreator
{
  std::shared_ptr<M> operator()() {return std::make_shared<M>();}
};

template<typename M>
class MessageEvent
{
public:
  using ConstMessage = std::add_const_t<M>;
  using Message = std::remove_const_t<M>;
  using MessagePtr = std::shared_ptr<Message>;
  using ConstMessagePtr = std::shared_ptr<ConstMessage>;
  using CreateFunction = std::function<MessagePtr()>;

  MessageEvent() = default;
  MessageEvent(const MessageEvent &) = default;
  MessageEvent & operator=(const MessageEvent &) = default;
  /// Of one for the other kind of reader.
  template<typename Other, typename = std::enable_if_t<!std::is_same_v<Other, M> && std::is_same_v<std::remove_const_t<Other>, Message>>>
  MessageEvent(const MessageEvent<Other> & other)  // NOLINT: as Humble's
  : MessageEvent(other, other.nonConstWillCopy()) {}
  template<typename Other, typename = std::enable_if_t<std::is_same_v<std::remove_const_t<Other>, Message>>>
  MessageEvent(const MessageEvent<Other> & other, bool nonconst_need_copy)
  : MessageEvent(other.getConstMessage(), other.getReceiptTime(), nonconst_need_copy, other.getMessageFactory()) {}
  MessageEvent(const ConstMessagePtr & message)  // NOLINT: as Humble's
  : MessageEvent(message, rclcpp::Clock().now()) {}
  MessageEvent(const ConstMessagePtr & message, rclcpp::Time receipt_time)
  : MessageEvent(message, receipt_time, true, DefaultMessageCreator<Message>()) {}
  MessageEvent(const ConstMessagePtr & message, rclcpp::Time receipt_time, bool nonconst_need_copy, const CreateFunction & create)
  : message_(message), receipt_time_(receipt_time), nonconst_need_copy_(nonconst_need_copy), create_(create) {}

  /// The message. Whoever may change it gets a copy of their own, except where nobody else has it.
  std::shared_ptr<M> getMessage() const
  {
    if constexpr (std::is_const_v<M>) {
      return message_;
    } else {
      return changeable();
    }
  }
  const ConstMessagePtr & getConstMessage() const {return message_;}
  rclcpp::Time getReceiptTime() const {return receipt_time_;}
  bool nonConstWillCopy() const {return nonconst_need_copy_;}
  bool getMessageWillCopy() const {return !std::is_const_v<M> && nonconst_need_copy_;}
  const CreateFunction & getMessageFactory() const {return create_;}

  bool operator<(const MessageEvent & other) const
  {
    if (message_ != other.message_) {
      return message_ < other.message_;
    }
    const auto here = receipt_time_.nanoseconds(), there = other.receipt_time_.nanoseconds();
    return here != there ? here < there : nonconst_need_copy_ < other.nonconst_need_copy_;
  }
  bool operator==(const MessageEvent & other) const {return !(*this < other) && !(other < *this);}
  bool operator!=(const MessageEvent & other) const {return !(*this == other);}

private:
  MessagePtr changeable() const
  {
    if (!message_ || !nonconst_need_copy_) {
      return std::const_pointer_cast<Message>(message_);
    }
    if (!copy_) {
      copy_ = create_();
      *copy_ = *message_;
    }
    return copy_;
  }
  ConstMessagePtr message_;
  mutable MessagePtr copy_;
  rclcpp::Time receipt_time_;
  bool nonconst_need_copy_ = true;
  CreateFunction create_;
};
}  // namespace message_filters
