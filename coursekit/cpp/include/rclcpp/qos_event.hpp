// What QoS events tell, and the callbacks that hear of them.
#pragma once
#include <functional>
#include <unordered_map>

#include "coursekit/entity.hpp"
#include "rclcpp/exceptions.hpp"
#include "rclcpp/qos.hpp"
#include "rclcpp/waitable.hpp"

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

/// One kind of event that somebody listens to. A node's executor has its callback called; it may be waited for beside that.
class QOSEventHandlerBase : public Waitable
{
public:
  enum class EntityType : size_t {Event};
  /// Reads what the event tells, and calls back.
  using Call = std::function<void (Unpacker &)>;
  QOSEventHandlerBase(std::weak_ptr<coursekit::Entity> owner, int64_t kind, Call call)
  : owner_(std::move(owner)), kind_(kind), call_(std::move(call)) {}
  size_t get_number_of_ready_events() override {return 1;}
  void add_to_wait_set(rcl_wait_set_t * wait_set) override;
  bool is_ready(rcl_wait_set_t * wait_set) override;
  std::shared_ptr<void> take_data() override;
  std::shared_ptr<void> take_data_by_entity_id(size_t) override {return take_data();}
  void execute(std::shared_ptr<void> & data) override {call_(*std::static_pointer_cast<Unpacker>(data));}
  void set_on_ready_callback(std::function<void (size_t, int)> callback) override;
  void clear_on_ready_callback() override;
  const Call & call() const {return call_;}

private:
  std::weak_ptr<coursekit::Entity> owner_;
  int64_t kind_;
  Call call_;
  coursekit::Entity event_;
  size_t index_ = 0;
};
template<class Type>
using EventHandlers = std::unordered_map<Type, std::shared_ptr<QOSEventHandlerBase>>;
}  // namespace rclcpp
