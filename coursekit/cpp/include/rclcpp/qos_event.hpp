// What QoS events tell, and the callbacks that hear of them.
#pragma once
#include <functional>

#include "rclcpp/exceptions.hpp"
#include "rclcpp/qos.hpp"

struct rmw_event_count_t {int32_t total_count = 0, total_count_change = 0;};
struct rmw_qos_incompatible_event_status_t : rmw_event_count_t {rmw_qos_policy_kind_t last_policy_kind = RMW_QOS_POLICY_INVALID;};
struct rmw_liveliness_changed_status_t
{
  int32_t alive_count = 0, not_alive_count = 0, alive_count_change = 0, not_alive_count_change = 0;
};
struct rmw_message_lost_status_t {size_t total_count = 0, total_count_change = 0;};

enum rcl_publisher_event_type_t
{
  RCL_PUBLISHER_OFFERED_DEADLINE_MISSED, RCL_PUBLISHER_LIVELINESS_LOST, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS
};
enum rcl_subscription_event_type_t
{
  RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED, RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
  RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, RCL_SUBSCRIPTION_MESSAGE_LOST
};

namespace rclcpp
{
/// A set of kinds of events.
template<class Type>
class EventTypes
{
public:
  void add(Type type, bool wanted) {bits_ |= wanted ? 1u << type : 0u;}
  bool has(Type type) const {return bits_ >> type & 1u;}

private:
  unsigned bits_ = 0;
};
using QOSDeadlineRequestedInfo = rmw_event_count_t;
using QOSDeadlineOfferedInfo = rmw_event_count_t;
using QOSLivelinessLostInfo = rmw_event_count_t;
using QOSLivelinessChangedInfo = rmw_liveliness_changed_status_t;
using QOSMessageLostInfo = rmw_message_lost_status_t;
using QOSOfferedIncompatibleQoSInfo = rmw_qos_incompatible_event_status_t;
using QOSRequestedIncompatibleQoSInfo = rmw_qos_incompatible_event_status_t;

using QOSDeadlineRequestedCallbackType = std::function<void (QOSDeadlineRequestedInfo &)>;
using QOSDeadlineOfferedCallbackType = std::function<void (QOSDeadlineOfferedInfo &)>;
using QOSLivelinessChangedCallbackType = std::function<void (QOSLivelinessChangedInfo &)>;
using QOSLivelinessLostCallbackType = std::function<void (QOSLivelinessLostInfo &)>;
using QOSMessageLostCallbackType = std::function<void (QOSMessageLostInfo &)>;
using QOSOfferedIncompatibleQoSCallbackType = std::function<void (QOSOfferedIncompatibleQoSInfo &)>;
using QOSRequestedIncompatibleQoSCallbackType = std::function<void (QOSRequestedIncompatibleQoSInfo &)>;
using UnsupportedEventTypeException = exceptions::UnsupportedEventTypeException;

struct PublisherEventCallbacks
{
  QOSDeadlineOfferedCallbackType deadline_callback;
  QOSLivelinessLostCallbackType liveliness_callback;
  QOSOfferedIncompatibleQoSCallbackType incompatible_qos_callback;
};
struct SubscriptionEventCallbacks
{
  QOSDeadlineRequestedCallbackType deadline_callback;
  QOSLivelinessChangedCallbackType liveliness_callback;
  QOSRequestedIncompatibleQoSCallbackType incompatible_qos_callback;
  QOSMessageLostCallbackType message_lost_callback;
};
}  // namespace rclcpp
