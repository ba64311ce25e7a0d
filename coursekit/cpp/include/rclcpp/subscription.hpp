// Subscriptions.
#pragma once
#include "coursekit/wait_set_part.hpp"
#include "rclcpp/any_subscription_callback.hpp"
#include "rclcpp/message_memory_strategy.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/typesupport_helpers.hpp"

namespace rclcpp
{
namespace node_interfaces
{
class NodeBaseInterface;
}

class SubscriptionBase
  : public coursekit::Entity, public coursekit::WaitSetPart, public std::enable_shared_from_this<SubscriptionBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(SubscriptionBase)
  using Dispatch = std::function<void (const std::string & cdr, const MessageInfo & info)>;

  const char * get_topic_name() const {return name.c_str();}
  size_t get_publisher_count() const {return static_cast<size_t>(ask("publisher_count", Packer{}.i(id)).i());}
  QoS get_actual_qos() const {return qos;}
  virtual bool is_serialized() const {return false;}
  virtual const rosidl_message_type_support_t & get_message_type_support_handle() const = 0;
  bool can_loan_messages() const {return false;}
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  /// The events that it has callbacks for.
  const EventHandlers<rcl_subscription_event_type_t> & get_event_handlers() const {return events;}
  std::shared_ptr<coursekit::Entity> get_subscription_handle() {return shared_from_this();}
  std::shared_ptr<const coursekit::Entity> get_subscription_handle() const {return shared_from_this();}

  /// Have a function called with how many messages have come, as soon as they have.
  void set_on_new_message_callback(std::function<void (size_t)> callback)
  {
    news.tell(
      *this, coursekit::ITSELF, {"set_on_new_message_callback", "rclcpp::SubscriptionBase", "on new message"},
      std::move(callback));
  }
  void clear_on_new_message_callback() {news.tell_no_more(*this, coursekit::ITSELF);}
  /// The same for messages that stay in the program.
  void set_on_new_intra_process_message_callback(std::function<void (size_t)> callback);
  void clear_on_new_intra_process_message_callback();
  void set_on_new_qos_event_callback(std::function<void (size_t)> callback, rcl_subscription_event_type_t event);
  void clear_on_new_qos_event_callback(rcl_subscription_event_type_t event);

  /// Whether only messages for which an expression holds are heard.
  bool is_cft_enabled() const {return !filter_.filter_expression.empty();}
  void set_content_filter(const std::string & expression, const std::vector<std::string> & parameters = {})
  {
    Packer with = Packer{}.i(id).s(expression).i(static_cast<int64_t>(parameters.size()));
    for (auto & parameter : parameters) {
      with.s(parameter);
    }
    ask("content_filter", with);
    filter_ = {expression, parameters};
  }
  ContentFilterOptions get_content_filter() const {return filter_;}
  /// Take the next message's bytes without waiting; false where there is none.
  bool take_bytes(std::string & cdr, MessageInfo & info)
  {
    Unpacker answer = ask("take", Packer{}.i(id));
    if (!answer.i()) {
      return false;
    }
    unpack_info(answer, info);
    cdr = answer.rest();
    return true;
  }
  /// Run the callback with a message that was taken.
  virtual void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) = 0;
  /// The same with a message that a middleware lends: it stays as it is, and the callback gets a copy.
  virtual void handle_loaned_message(void * message, const MessageInfo & info) = 0;
  virtual std::shared_ptr<void> create_message() = 0;
  virtual void return_message(std::shared_ptr<void> & message) {message.reset();}
  virtual std::shared_ptr<SerializedMessage> create_serialized_message() {return std::make_shared<SerializedMessage>();}
  virtual void return_serialized_message(std::shared_ptr<SerializedMessage> & message) {message.reset();}
  virtual bool take_type_erased(void * message, MessageInfo & info) = 0;
  bool take_serialized(SerializedMessage & message, MessageInfo & info)
  {
    std::string cdr;
    if (!take_bytes(cdr, info)) {
      return false;
    }
    message = SerializedMessage(cdr);
    return true;
  }
  static void unpack_info(Unpacker & from, MessageInfo & info)
  {
    auto & rmw = info.get_rmw_message_info();
    rmw.source_timestamp = from.i();
    rmw.received_timestamp = from.i();
    std::string gid = from.s();
    std::copy_n(gid.begin(), std::min(gid.size(), sizeof(rmw.publisher_gid.data)), rmw.publisher_gid.data);
    rmw.publisher_gid.implementation_identifier = "coursekit";
  }
  /// Mark it, or one of its events, as one of a wait set or of none; whether it was one before.
  bool exchange_in_use_by_wait_set_state(void * part, bool in_use);
  Dispatch dispatch;
  QoS qos{10};
  /// What stays in the program for it; null where all that it hears goes through the session.
  std::shared_ptr<intra_process::Inbox> inbox;
  /// The C++ type of what it takes, and whether it takes it as its own; null where it takes bytes.
  const std::type_info * taken_type = nullptr;
  bool owns = false;
  EventHandlers<rcl_subscription_event_type_t> events;
  /// How a node takes in one that the program constructed; empty where it has.
  std::function<void (node_interfaces::NodeBaseInterface &, CallbackGroup::SharedPtr)> entering;

protected:
  /// Get ready for the node that will take it in.
  void prepare(
    const node_interfaces::NodeBaseInterface & node, const std::string & type, const std::string & topic, const QoS & wanted,
    const SubscriptionOptionsBase & options);
  ContentFilterOptions filter_;
};

template<class T, class Allocator = std::allocator<void>, class ...>
class Subscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Subscription)
  using MessageT = T;
  using SubscribedType = CustomOf<T>;
  using ROSMessageType = MessageOf<T>;
  using MessageMemoryStrategyType = message_memory_strategy::MessageMemoryStrategy<ROSMessageType, Allocator>;
  Subscription() = default;
  /// One that hears as soon as a node takes it in, with NodeTopicsInterface::add_subscription().
  Subscription(
    node_interfaces::NodeBaseInterface * node, const rosidl_message_type_support_t &, const std::string & topic, const QoS & wanted,
    AnySubscriptionCallback<T, Allocator> callback, const SubscriptionOptionsWithAllocator<Allocator> & options,
    typename MessageMemoryStrategyType::SharedPtr strategy = nullptr, std::nullptr_t = nullptr)
  {
    take_messages_from(std::move(strategy));
    call_back(std::move(callback));
    prepare(*node, ROSMessageType::coursekit_type, topic, wanted, options);
  }
  const rosidl_message_type_support_t & get_message_type_support_handle() const override
  {
    return rclcpp::get_message_type_support_handle<T>();
  }
  bool take(ROSMessageType & message, MessageInfo & info)
  {
    std::string cdr;
    if (!take_bytes(cdr, info)) {
      return false;
    }
    coursekit::from_cdr(cdr, message);
    return true;
  }
  bool take_type_erased(void * message, MessageInfo & info) override
  {
    return take(*static_cast<ROSMessageType *>(message), info);
  }
  std::shared_ptr<void> create_message() override
  {
    return strategy_ ? strategy_->borrow_message() : std::make_shared<ROSMessageType>();
  }
  void return_message(std::shared_ptr<void> & message) override
  {
    if (strategy_) {
      auto typed = std::static_pointer_cast<ROSMessageType>(message);
      strategy_->return_message(typed);
    }
    message.reset();
  }
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) override
  {
    handle_loaned_message(message.get(), info);
  }
  void handle_loaned_message(void * message, const MessageInfo & info) override
  {
    dispatch(coursekit::to_cdr(*static_cast<ROSMessageType *>(message)), info);
  }
  /// Whether the callback may share a message with others.
  bool use_take_shared_method() const {return !owns;}
  /// Have messages lent by a strategy of the program's.
  void take_messages_from(typename MessageMemoryStrategyType::SharedPtr strategy) {strategy_ = std::move(strategy);}
  void take_messages_from() {}
  void call_back(AnySubscriptionCallback<T, Allocator> given)
  {
    auto any = std::make_shared<AnySubscriptionCallback<T, Allocator>>(std::move(given));
    dispatch = [this, any](const std::string & cdr, const MessageInfo & info) {
        if (strategy_ && !any->is_serialized_message_callback()) {
          auto message = strategy_->borrow_message();
          coursekit::from_cdr(cdr, *message);
          any->dispatch(message, info);
          return strategy_->return_message(message);
        }
        any->dispatch(std::make_shared<SerializedMessage>(cdr), info);
      };
  }
  /// Have what comes call a function of the program.
  template<class F>
  void call_back(F && given)
  {
    using Callback = std::decay_t<F>;
    using Taken = std::conditional_t<takes<Callback, SubscribedType>, SubscribedType, ROSMessageType>;
    constexpr bool takes_objects = takes<Callback, Taken>;
    if constexpr (takes_objects) {
      taken_type = &typeid(Taken);
      owns = !shares<Callback, Taken>;
    }
    dispatch = [this, callback = Callback(std::forward<F>(given))](const std::string & cdr, const MessageInfo & info) mutable {
        if constexpr (takes_objects) {
          if (inbox && call_with_kept<Taken>(callback, *inbox, cdr, info)) {
            return;
          }
        }
        if (strategy_) {
          return call_with_borrowed<T>(callback, *strategy_, cdr, info);
        }
        call_with_bytes<T>(callback, cdr, info);
      };
  }

private:
  typename MessageMemoryStrategyType::SharedPtr strategy_;
};

/// Hears the bytes of a type that only its name tells.
class GenericSubscription : public SubscriptionBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericSubscription)
  bool is_serialized() const override {return true;}
  explicit GenericSubscription(const std::string & type)
  : type_support_(detail::type_support_called(type)) {}
  const rosidl_message_type_support_t & get_message_type_support_handle() const override {return *type_support_;}
  /// Have what comes call a function of the program.
  template<class F>
  void call_back(F && given)
  {
    dispatch = [callback = std::decay_t<F>(std::forward<F>(given))](const std::string & cdr, const MessageInfo & info) mutable {
        call_with(callback, std::make_unique<SerializedMessage>(cdr), info);
      };
  }
  std::shared_ptr<void> create_message() override {return std::make_shared<SerializedMessage>();}
  bool take_type_erased(void * message, MessageInfo & info) override
  {
    return take_serialized(*static_cast<SerializedMessage *>(message), info);
  }
  void handle_message(std::shared_ptr<void> & message, const MessageInfo & info) override
  {
    dispatch(std::static_pointer_cast<SerializedMessage>(message)->bytes(), info);
  }
  void handle_loaned_message(void *, const MessageInfo &) override
  {
    throw std::runtime_error("handle_loaned_message is not implemented for GenericSubscription");
  }

private:
  const rosidl_message_type_support_t * type_support_;
};
}  // namespace rclcpp
