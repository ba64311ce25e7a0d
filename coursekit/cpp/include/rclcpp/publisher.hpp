// Publishers.
#pragma once
#include <algorithm>
#include <chrono>
#include <iterator>

#include "rclcpp/allocator/allocator_common.hpp"
#include "rclcpp/intra_process.hpp"
#include "rclcpp/logging.hpp"
#include "rclcpp/network_flow_endpoint.hpp"
#include "rclcpp/publisher_options.hpp"
#include "rclcpp/serialized_message.hpp"
#include "rclcpp/type_adapter.hpp"
#include "rclcpp/utilities.hpp"

namespace rclcpp
{
namespace node_interfaces
{
class NodeBaseInterface;
}

class PublisherBase : public coursekit::Entity, public std::enable_shared_from_this<PublisherBase>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(PublisherBase)
  const char * get_topic_name() const {return name.c_str();}
  size_t get_queue_size() const {return qos.depth();}
  size_t get_subscription_count() const {return static_cast<size_t>(ask("subscription_count", Packer{}.i(id)).i());}
  virtual size_t get_intra_process_subscription_count() const {return 0;}
  bool assert_liveliness() const
  {
    ask("assert_liveliness", Packer{}.i(id));
    return true;
  }
  QoS get_actual_qos() const {return qos;}
  const rmw_gid_t & get_gid() const {return gid;}
  /// Whether a message's publisher is this one, by its number.
  bool operator==(const rmw_gid_t & other) const {return std::equal(std::begin(gid.data), std::end(gid.data), other.data);}
  bool operator==(const rmw_gid_t * other) const {return *this == *other;}
  std::vector<NetworkFlowEndpoint> get_network_flow_endpoints() const {return {};}
  bool can_loan_messages() const {return false;}
  template<class Rep = int64_t, class Period = std::milli>
  bool wait_for_all_acked(std::chrono::duration<Rep, Period> = std::chrono::duration<Rep, Period>(-1)) const
  {
    ask("subscription_count", Packer{}.i(id));  // its answer comes behind what was published: the queues have that then
    return true;
  }
  /// The events that it has callbacks for.
  const EventHandlers<rcl_publisher_event_type_t> & get_event_handlers() const {return events;}
  std::shared_ptr<coursekit::Entity> get_publisher_handle() {return shared_from_this();}
  std::shared_ptr<const coursekit::Entity> get_publisher_handle() const {return shared_from_this();}
  /// Have a function called with how many events of a kind have happened, as soon as they have.
  void set_on_new_qos_event_callback(std::function<void (size_t)> callback, rcl_publisher_event_type_t event);
  void clear_on_new_qos_event_callback(rcl_publisher_event_type_t event);
  QoS qos{10};
  rmw_gid_t gid{};
  Context::SharedPtr context;
  /// Whether what is published may stay in the program.
  bool intra_process = false;
  EventHandlers<rcl_publisher_event_type_t> events;
  /// How a node takes in one that the program constructed; empty where it has.
  std::function<void (node_interfaces::NodeBaseInterface &, CallbackGroup::SharedPtr)> entering;

protected:
  /// Get ready for the node that will take it in.
  void prepare(
    const node_interfaces::NodeBaseInterface & node, const std::string & type, const std::string & topic, const QoS & wanted,
    const PublisherOptionsBase & options);
  void send(const std::string & cdr) const
  {
    if (ok(context)) {
      coursekit::note("publish", Packer{}.i(id).raw(cdr.data(), cdr.size()));
    }
  }
};

/// A message that a publisher lends: here it is the program's own memory.
template<class M, class Allocator = std::allocator<void>>
class LoanedMessage
{
public:
  LoanedMessage()
  : message_(std::make_unique<M>())
  {
    RCLCPP_INFO_ONCE(
      get_logger("rclcpp"), "Currently used middleware can't loan messages. Local allocator will be used.");
  }
  LoanedMessage(const PublisherBase &, std::allocator<M>)
  : LoanedMessage() {}
  template<class MessageAllocator>
  LoanedMessage(const PublisherBase &, std::shared_ptr<MessageAllocator>)
  : LoanedMessage() {}
  template<class MessageAllocator>
  LoanedMessage(const PublisherBase *, std::shared_ptr<MessageAllocator>)
  : LoanedMessage() {}
  bool is_valid() const {return message_ != nullptr;}
  M & get() const {return *message_;}
  std::unique_ptr<M> release() {return std::move(message_);}

private:
  std::unique_ptr<M> message_;
};

template<class T, class Allocator = std::allocator<void>>
class Publisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Publisher)
  using MessageT = T;
  using PublishedType = CustomOf<T>;
  using ROSMessageType = MessageOf<T>;
  using MessageUniquePtr = std::unique_ptr<ROSMessageType>;
  using MessageSharedPtr = std::shared_ptr<const ROSMessageType>;
  using ROSMessageTypeAllocator = typename allocator::AllocRebind<ROSMessageType, Allocator>::allocator_type;
  Publisher() = default;
  /// One that publishes as soon as a node takes it in, with NodeTopicsInterface::add_publisher().
  Publisher(
    node_interfaces::NodeBaseInterface * node, const std::string & topic, const QoS & wanted,
    const PublisherOptionsWithAllocator<Allocator> & options)
  {
    prepare(*node, ROSMessageType::coursekit_type, topic, wanted, options);
  }

  void publish(const PublishedType & message) {send(custom_to_cdr<T>(message));}
  template<class Deleter>
  void publish(std::unique_ptr<PublishedType, Deleter> message)
  {
    if constexpr (std::is_same_v<Deleter, std::default_delete<PublishedType>>) {
      if (intra_process) {
        std::string bytes = custom_to_cdr<T>(*message);
        rclcpp::intra_process::give(name, std::move(message), bytes);  // first: a subscription may hear the bytes at once
        return send(bytes);
      }
    }
    publish(*message);
  }
  template<class M, class Deleter, class = std::enable_if_t<is_adapted<T> && std::is_same_v<M, ROSMessageType>>>
  void publish(std::unique_ptr<M, Deleter> message) {publish(*message);}
  template<class M, class = std::enable_if_t<is_adapted<T> && std::is_same_v<M, ROSMessageType>>>
  void publish(const M & message) {send(coursekit::to_cdr(message));}
  void publish(const SerializedMessage & message) {publish(message.get_rcl_serialized_message());}
  void publish(const rcl_serialized_message_t & message)
  {
    if (intra_process) {
      throw std::runtime_error("storing serialized messages in intra process is not supported yet");
    }
    send(std::string(reinterpret_cast<const char *>(message.buffer), message.buffer_length));
  }
  void publish(LoanedMessage<PublishedType> && message)
  {
    if (!message.is_valid()) {
      throw std::runtime_error("loaned message is not valid");
    }
    publish(message.release());
  }
  LoanedMessage<PublishedType> borrow_loaned_message() {return {};}
  std::shared_ptr<ROSMessageTypeAllocator> get_allocator() const {return std::make_shared<ROSMessageTypeAllocator>();}
  size_t get_intra_process_subscription_count() const override
  {
    return intra_process ? rclcpp::intra_process::inboxes(name, typeid(PublishedType)).size() : 0;
  }
};

/// Publishes bytes of a type that only its name tells.
class GenericPublisher : public PublisherBase
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(GenericPublisher)
  void publish(const SerializedMessage & message) {send(message.bytes());}
  void publish_as_loaned_msg(const SerializedMessage & message) {publish(message);}
};
}  // namespace rclcpp
