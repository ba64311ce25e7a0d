// How a node's entities are made: each is entered at the session with a handler that calls the program back.
#pragma once
#include "rclcpp/client.hpp"
#include "rclcpp/node_interfaces/node_base_interface.hpp"
#include "rclcpp/publisher.hpp"
#include "rclcpp/service.hpp"
#include "rclcpp/subscription.hpp"
#include "rclcpp/timer.hpp"

namespace rclcpp::detail
{
using NodeBase = node_interfaces::NodeBaseInterface;

inline int64_t number_of(const CallbackGroup::SharedPtr & group) {return group ? group->id : 0;}
/// Write down what a node has made, in the group that was given, else in its own.
template<class E>
void enlist(NodeBase & node, const CallbackGroup::SharedPtr & group, const std::shared_ptr<E> & made)
{
  (group ? group : node.group)->enlist(made);
}

/// Ask the session for an entity; it answers with its number and the name that remapping gave it.
inline void enter(const char * what, const Packer & with, coursekit::Entity & made)
{
  Unpacker answer = ask(what, with);
  made.id = answer.i();
  made.name = answer.s();
}

/// Make the handlers of an end's events: of those that the program has callbacks for, and rclcpp's own warnings.
void listen_to_events(NodeBase & node, PublisherBase & made, const PublisherOptionsBase & options);
void listen_to_events(NodeBase & node, SubscriptionBase & made, const SubscriptionOptionsBase & options);
void make_publisher(
  NodeBase & node, PublisherBase & made, const std::string & type, const std::string & topic, const QoS & qos,
  const PublisherOptionsBase & options);
void make_subscription(
  NodeBase & node, const SubscriptionBase::SharedPtr & made, const std::string & type, const std::string & topic,
  const QoS & qos, const SubscriptionOptionsBase & options);
void make_timer(NodeBase & node, const TimerBase::SharedPtr & made, const CallbackGroup::SharedPtr & group);

/// Make a publisher of a program's own class, which may have rclcpp's constructor alone.
template<class P, class Options>
std::shared_ptr<P> publisher(
  NodeBase & node, const std::string & type, const std::string & topic, const QoS & qos, const Options & options)
{
  if constexpr (std::is_default_constructible_v<P>) {
    auto made = std::make_shared<P>();
    make_publisher(node, *made, type, topic, qos, options);
    return made;
  } else {
    auto made = std::make_shared<P>(&node, topic, qos, options);
    node.add_publisher(made, options.callback_group);
    return made;
  }
}

template<class F>
TimerBase::SharedPtr timer(
  NodeBase & node, std::chrono::nanoseconds period, F callback, const CallbackGroup::SharedPtr & group,
  const Clock::SharedPtr & clock)
{
  auto made = std::make_shared<GenericTimer<F>>(clock, period, std::move(callback));
  make_timer(node, made, group);
  return made;
}

template<class S, class F>
typename Service<S>::SharedPtr service(
  NodeBase & node, const std::string & name, F && callback, const QoS & qos, const CallbackGroup::SharedPtr & group)
{
  auto made = std::make_shared<Service<S>>();
  made->callback.set(std::forward<F>(callback));
  std::weak_ptr<Service<S>> weak = made;
  int64_t handler = made->handle(
    [weak](Unpacker & from, Packer & to) {
      auto header = std::make_shared<rmw_request_id_t>();
      header->sequence_number = from.i();
      auto request = std::make_shared<typename S::Request>();
      coursekit::from_cdr(from.rest(), *request);
      auto me = weak.lock();
      auto response = me ? me->answer(header, request) : nullptr;
      to.i(response != nullptr).m(response ? *response : typename S::Response());
    });
  Packer with = Packer{}.i(node.id).s(S::coursekit_type).s(name).i(handler).i(number_of(group));
  qos.pack(with);
  made->qos = qos;
  enter("service", with, *made);
  enlist<ServiceBase>(node, group, made);
  return made;
}

template<class S>
typename Client<S>::SharedPtr client(
  NodeBase & node, const std::string & name, const QoS & qos, const CallbackGroup::SharedPtr & group)
{
  auto made = std::make_shared<Client<S>>();
  std::weak_ptr<Client<S>> weak = made;
  int64_t handler = made->handle(
    [weak](Unpacker & from, Packer &) {
      int64_t number = from.i();
      if (auto me = weak.lock()) {
        me->receive(number, from.rest());
      }
    });
  Packer with = Packer{}.i(node.id).s(S::coursekit_type).s(name).i(handler).i(number_of(group));
  qos.pack(with);
  made->qos = qos;
  enter("client", with, *made);
  enlist<ClientBase>(node, group, made);
  return made;
}
}  // namespace rclcpp::detail
