// Events of publishers and subscriptions: what they tell, who hears it, and how they are waited for.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
// -- as waitables

void QOSEventHandlerBase::add_to_wait_set(rcl_wait_set_t * wait_set)
{
  auto owner = owner_.lock();
  if (owner && !event_.id) {
    event_.id = ask("event", Packer{}.i(owner->id).i(kind_)).i();
  }
  if (owner) {
    rcl_wait_set_add_event(wait_set, &event_, &index_);
  }
}
bool QOSEventHandlerBase::is_ready(rcl_wait_set_t * wait_set)
{
  return index_ < wait_set->events.size() && wait_set->events[index_] == &event_;
}
std::shared_ptr<void> QOSEventHandlerBase::take_data()
{
  return std::make_shared<Unpacker>(ask("take_event", Packer{}.i(event_.id)));
}
void QOSEventHandlerBase::set_on_ready_callback(std::function<void (size_t, int)> callback)
{
  if (!callback) {
    throw std::invalid_argument("The callback passed to set_on_ready_callback is not callable.");
  }
  if (auto owner = owner_.lock()) {
    owner->news.tell(
      *owner, kind_, {"set_on_ready_callback", "rclcpp::QOSEventHandlerBase", "on ready"},
      [callback](size_t count) {callback(count, static_cast<int>(EntityType::Event));});
  }
}
void QOSEventHandlerBase::clear_on_ready_callback()
{
  if (auto owner = owner_.lock()) {
    owner->news.tell_no_more(*owner, kind_);
  }
}

// -- what they tell

namespace
{
void unpack(Unpacker & from, rmw_event_count_t & info)
{
  info.total_count = static_cast<int32_t>(from.i());
  info.total_count_change = static_cast<int32_t>(from.i());
}
void unpack(Unpacker & from, rmw_qos_incompatible_event_status_t & info)
{
  unpack(from, static_cast<rmw_event_count_t &>(info));
  info.last_policy_kind = static_cast<rmw_qos_policy_kind_t>(from.i());
}
void unpack(Unpacker & from, rmw_liveliness_changed_status_t & info)
{
  info.alive_count = static_cast<int32_t>(from.i());
  info.not_alive_count = static_cast<int32_t>(from.i());
  info.alive_count_change = static_cast<int32_t>(from.i());
  info.not_alive_count_change = static_cast<int32_t>(from.i());
}
void unpack(Unpacker & from, rmw_message_lost_status_t & info)
{
  info.total_count = static_cast<size_t>(from.i());
  info.total_count_change = static_cast<size_t>(from.i());
}
template<class Owner, class Type, class Info>
void listen(Owner & owner, Type kind, const std::function<void (Info &)> & callback)
{
  if (callback) {
    owner.events[kind] = std::make_shared<QOSEventHandlerBase>(
      owner.weak_from_this(), kind, [callback](Unpacker & from) {
        Info info;
        unpack(from, info);
        callback(info);
      });
  }
}
/// What hears of ends that do not match: the program's callback, else a warning where it is not switched off.
template<class Owner, class Options>
QOSOfferedIncompatibleQoSCallbackType about_mismatch(
  const detail::NodeBase & node, Owner & owner, const Options & options, const char * warning)
{
  auto & given = options.event_callbacks.incompatible_qos_callback;
  if (given || !options.use_default_callbacks) {
    return given;
  }
  return [logger = node.get_logger(), weak = owner.weak_from_this(), warning](auto & info) {
           if (auto me = weak.lock()) {
             const std::string policy = qos_policy_name_from_kind(info.last_policy_kind);
             RCLCPP_WARN(logger, warning, me->get_topic_name(), policy.c_str());
           }
         };
}
}  // namespace

void detail::listen_to_events(NodeBase & node, PublisherBase & made, const PublisherOptionsBase & options)
{
  listen(made, RCL_PUBLISHER_OFFERED_DEADLINE_MISSED, options.event_callbacks.deadline_callback);
  listen(made, RCL_PUBLISHER_LIVELINESS_LOST, options.event_callbacks.liveliness_callback);
  listen(made, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS, about_mismatch(node, made, options,
    "New subscription discovered on topic '%s', requesting incompatible QoS. No messages will be sent to it. "
    "Last incompatible policy: %s"));
}
void detail::listen_to_events(NodeBase & node, SubscriptionBase & made, const SubscriptionOptionsBase & options)
{
  listen(made, RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED, options.event_callbacks.deadline_callback);
  listen(made, RCL_SUBSCRIPTION_LIVELINESS_CHANGED, options.event_callbacks.liveliness_callback);
  listen(made, RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, about_mismatch(node, made, options,
    "New publisher discovered on topic '%s', offering incompatible QoS. No messages will be sent to it. "
    "Last incompatible policy: %s"));
  listen(made, RCL_SUBSCRIPTION_MESSAGE_LOST, options.event_callbacks.message_lost_callback);
}
}  // namespace rclcpp
