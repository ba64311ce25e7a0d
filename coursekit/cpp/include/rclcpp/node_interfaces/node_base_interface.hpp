// The interfaces of a node. rclcpp has ten classes of them; here one object is all ten.
#pragma once
#include <map>
#include <mutex>
#include <tuple>

#include "rcl_interfaces/msg/list_parameters_result.hpp"
#include "rcl_interfaces/msg/parameter_descriptor.hpp"
#include "rcl_interfaces/msg/set_parameters_result.hpp"
#include "rclcpp/callback_group.hpp"
#include "rclcpp/clock.hpp"
#include "rclcpp/event.hpp"
#include "rclcpp/logger.hpp"
#include "rclcpp/parameter.hpp"
#include "rclcpp/timer.hpp"
#include "rclcpp/topic_endpoint_info.hpp"

namespace rclcpp
{
struct PublisherFactory;
class PublisherBase;
class QoS;
struct SubscriptionFactory;
class SubscriptionBase;
class Waitable;
}

namespace rclcpp::node_interfaces
{
struct OnSetParametersCallbackHandle : coursekit::Entity
{
  RCLCPP_SMART_PTR_DEFINITIONS(OnSetParametersCallbackHandle)
  using OnParametersSetCallbackType =
    std::function<rcl_interfaces::msg::SetParametersResult (const std::vector<Parameter> &)>;
  OnParametersSetCallbackType callback;
};

class NodeBaseInterface : public std::enable_shared_from_this<NodeBaseInterface>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(NodeBaseInterface)
  using Descriptor = rcl_interfaces::msg::ParameterDescriptor;
  using OnParametersSetCallbackType = OnSetParametersCallbackHandle::OnParametersSetCallbackType;
  NodeBaseInterface() = default;
  NodeBaseInterface(const NodeBaseInterface &) = delete;
  virtual ~NodeBaseInterface();

  // -- base, logging, clock

  const char * get_name() const {return name.c_str();}
  const char * get_namespace() const {return space.c_str();}
  const char * get_fully_qualified_name() const {return full_name.c_str();}
  Context::SharedPtr get_context() {return context;}
  NodeBaseInterface * get_rcl_node_handle() {return this;}
  const NodeBaseInterface * get_rcl_node_handle() const {return this;}
  SharedPtr get_shared_rcl_node_handle() {return shared_from_this();}
  ConstSharedPtr get_shared_rcl_node_handle() const {return shared_from_this();}
  Logger get_logger() const {return logger;}
  const char * get_logger_name() const {return logger.get_name();}
  Clock::SharedPtr get_clock() {return clock;}
  Clock::ConstSharedPtr get_clock() const {return clock;}
  NodeBaseInterface * operator->() {return this;}
  bool get_use_intra_process_default() const {return intra_process;}
  bool get_enable_topic_statistics_default() const {return topic_statistics;}
  std::atomic<bool> & get_associated_with_executor_atomic() {return in_executor;}

  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatically_add_to_executor_with_node = true);
  CallbackGroup::SharedPtr get_default_callback_group() {return group;}
  bool callback_group_in_node(CallbackGroup::SharedPtr wanted);
  void for_each_callback_group(const std::function<void (CallbackGroup::SharedPtr)> & visit);
  void enter(const CallbackGroup::SharedPtr & made);

  // -- waitables

  /// Have the node's executor serve it, in the node's default group where no other is given.
  void add_waitable(std::shared_ptr<Waitable> waitable, CallbackGroup::SharedPtr group);
  void remove_waitable(std::shared_ptr<Waitable> waitable, CallbackGroup::SharedPtr group) noexcept;

  // -- timers

  /// Have the node's executor serve a timer that the program made itself, in the node's default group where no other is given.
  void add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr group);

  // -- topics, services

  std::shared_ptr<PublisherBase> create_publisher(const std::string & topic, const PublisherFactory & factory, const QoS & qos);
  void add_publisher(std::shared_ptr<PublisherBase> publisher, CallbackGroup::SharedPtr group);
  std::shared_ptr<SubscriptionBase> create_subscription(
    const std::string & topic, const SubscriptionFactory & factory, const QoS & qos);
  /// Have the node's executor serve it, in the node's default group where no other is given.
  void add_subscription(std::shared_ptr<SubscriptionBase> subscription, CallbackGroup::SharedPtr group);

  std::string resolve_topic_name(const std::string & topic, bool only_expand = false) const;
  std::string resolve_service_name(const std::string & service, bool only_expand = false) const;
  std::string resolve_topic_or_service_name(const std::string & name, bool is_service, bool only_expand = false) const;

  // -- parameters

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false);
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(), bool ignore_override = false);
  void undeclare_parameter(const std::string & name);
  bool has_parameter(const std::string & name) const;
  Parameter get_parameter(const std::string & name) const;
  bool get_parameter(const std::string & name, Parameter & parameter) const;
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const;
  /// Add the parameters below a prefix, by the rest of their names; whether there are any.
  bool get_parameters_by_prefix(const std::string & prefix, std::map<std::string, Parameter> & parameters) const;
  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter);
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<Parameter> & parameters);
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(const std::vector<Parameter> & parameters);
  Descriptor describe_parameter(const std::string & name) const;
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const;
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string> & names) const;
  rcl_interfaces::msg::ListParametersResult list_parameters(const std::vector<std::string> & prefixes, uint64_t depth) const;
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(OnParametersSetCallbackType callback);
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle);
  const std::map<std::string, ParameterValue> & get_parameter_overrides() const {return overrides;}

  // -- the graph

  std::vector<std::string> get_node_names() const;
  std::vector<std::pair<std::string, std::string>> get_node_names_and_namespaces() const;
  std::vector<std::tuple<std::string, std::string, std::string>> get_node_names_with_enclaves() const;
  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;
  NamesAndTypes get_topic_names_and_types(bool no_demangle = false) const;
  NamesAndTypes get_service_names_and_types() const;
  size_t count_publishers(const std::string & topic) const;
  size_t count_subscribers(const std::string & topic) const;
  NamesAndTypes get_service_names_and_types_by_node(const std::string & name, const std::string & space) const;
  NamesAndTypes get_client_names_and_types_by_node(const std::string & name, const std::string & space) const;
  NamesAndTypes get_publisher_names_and_types_by_node(
    const std::string & name, const std::string & space, bool no_demangle = false) const;
  NamesAndTypes get_subscriber_names_and_types_by_node(
    const std::string & name, const std::string & space, bool no_demangle = false) const;
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(const std::string & topic, bool no_mangle = false) const;
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(const std::string & topic, bool no_mangle = false) const;
  /// An event that is set by wait_for_graph_change() when nodes, topics or services have come or gone since.
  Event::SharedPtr get_graph_event();
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout);

  int64_t id = 0;
  std::string name, space, full_name;
  Logger logger{""};
  CallbackGroup::SharedPtr group;
  Clock::SharedPtr clock;
  Context::SharedPtr context = contexts::get_global_default_context();
  std::map<std::string, ParameterValue> overrides;
  std::atomic<bool> in_executor{false};
  bool topic_statistics = false, intra_process = false;

private:
  std::vector<rcl_interfaces::msg::SetParametersResult> set(const std::vector<Parameter> & parameters, bool together);
  NamesAndTypes names_and_types(const char * what, const Packer & with) const;
  NamesAndTypes ends_of(const char * which, const std::string & name, const std::string & space) const;
  std::vector<TopicEndpointInfo> endpoints(const char * what, const std::string & topic, bool no_mangle) const;
  std::mutex lock_;
  std::vector<CallbackGroup::WeakPtr> groups_;
  std::map<const Waitable *, std::shared_ptr<coursekit::Entity>> waitables_;
  std::map<const Event *, int64_t> graph_seen_;
  std::map<std::string, ParameterValue> declared_;
};
using NodeClockInterface = NodeBaseInterface;
using NodeGraphInterface = NodeBaseInterface;
using NodeLoggingInterface = NodeBaseInterface;
using NodeParametersInterface = NodeBaseInterface;
using NodeServicesInterface = NodeBaseInterface;
using NodeTimersInterface = NodeBaseInterface;
using NodeTimeSourceInterface = NodeBaseInterface;
using NodeTopicsInterface = NodeBaseInterface;
using NodeWaitablesInterface = NodeBaseInterface;
}  // namespace rclcpp::node_interfaces
namespace rclcpp
{
/// The logger of a node of C's functions; rclcpp's own where there is none.
inline Logger get_node_logger(const node_interfaces::NodeBaseInterface * node)
{
  return node ? node->get_logger() : get_logger("rclcpp");
}
/// Whether a subscription tells statistics about its topic, by its options and its node's.
namespace detail
{
template<class Options>
bool resolve_enable_topic_statistics(const Options & options, const node_interfaces::NodeBaseInterface & node)
{
  using State = decltype(options.topic_stats_options.state);
  return options.topic_stats_options.state == State::Enable ||
         (options.topic_stats_options.state == State::NodeDefault && node.get_enable_topic_statistics_default());
}
}  // namespace detail
}  // namespace rclcpp
