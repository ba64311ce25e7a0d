// Node: it lives at the session; here are its callbacks and the types of what it sends and hears.
#pragma once
#include "rclcpp/detail/entities.hpp"
#include "rclcpp/memory_strategy.hpp"
#include "rclcpp/node_options.hpp"

namespace rclcpp
{
/// A node of the Python process that this program is a part of, by its number at the session.
struct SharedNode
{
  int64_t id;
};

/// All that nodes have in common, with or without a lifecycle.
class NodeFace
{
public:
  using NodeBase = node_interfaces::NodeBaseInterface;
  using Descriptor = NodeBase::Descriptor;
  NodeFace(const std::string & name, const std::string & space, const NodeOptions & options, bool lifecycle);
  explicit NodeFace(SharedNode node);
  virtual ~NodeFace() = default;
  NodeFace(const NodeFace &) = delete;

  const char * get_name() const {return base_->get_name();}
  const char * get_namespace() const {return base_->get_namespace();}
  const char * get_fully_qualified_name() const {return base_->get_fully_qualified_name();}
  const std::string & get_sub_namespace() const {return sub_namespace_;}
  std::string get_effective_namespace() const;
  Logger get_logger() const {return base_->get_logger();}
  Clock::SharedPtr get_clock() {return base_->clock;}
  Clock::ConstSharedPtr get_clock() const {return base_->clock;}
  Time now() const {return base_->clock->now();}
  const NodeOptions & get_node_options() const {return options_;}
#define COURSEKIT_INTERFACE(name) \
  NodeBase::SharedPtr get_node_ ## name ## _interface() {return base_;}
  COURSEKIT_INTERFACE(base)
  COURSEKIT_INTERFACE(clock)
  COURSEKIT_INTERFACE(graph)
  COURSEKIT_INTERFACE(logging)
  COURSEKIT_INTERFACE(parameters)
  COURSEKIT_INTERFACE(services)
  COURSEKIT_INTERFACE(time_source)
  COURSEKIT_INTERFACE(timers)
  COURSEKIT_INTERFACE(topics)
  COURSEKIT_INTERFACE(waitables)

  CallbackGroup::SharedPtr create_callback_group(CallbackGroupType type, bool automatically_add_to_executor_with_node = true)
  {
    return base_->create_callback_group(type, automatically_add_to_executor_with_node);
  }
  void for_each_callback_group(const std::function<void (CallbackGroup::SharedPtr)> & visit)
  {
    base_->for_each_callback_group(visit);
  }

  // -- topics

  template<class T, class Alloc = std::allocator<void>, class PublisherT = Publisher<T, Alloc>>
  std::shared_ptr<PublisherT> create_publisher(
    const std::string & topic, const QoS & qos,
    const PublisherOptionsWithAllocator<Alloc> & options = PublisherOptionsWithAllocator<Alloc>())
  {
    return detail::publisher<PublisherT>(*base_, MessageOf<T>::coursekit_type, extended(topic), qos, options);
  }
  GenericPublisher::SharedPtr create_generic_publisher(
    const std::string & topic, const std::string & type, const QoS & qos, const PublisherOptions & options = {})
  {
    auto made = std::make_shared<GenericPublisher>();
    detail::make_publisher(*base_, *made, type, extended(topic), qos, options);
    return made;
  }

  template<class T, class F, class Alloc = std::allocator<void>, class ... Strategy>
  typename Subscription<T, Alloc>::SharedPtr create_subscription(
    const std::string & topic, const QoS & qos, F && callback,
    const SubscriptionOptionsWithAllocator<Alloc> & options = SubscriptionOptionsWithAllocator<Alloc>(),
    const Strategy & ... strategy)
  {
    auto made = std::make_shared<Subscription<T, Alloc>>();
    made->take_messages_from(strategy ...);
    made->call_back(std::forward<F>(callback));
    detail::make_subscription(*base_, made, MessageOf<T>::coursekit_type, extended(topic), qos, options);
    return made;
  }
  template<class F>
  GenericSubscription::SharedPtr create_generic_subscription(
    const std::string & topic, const std::string & type, const QoS & qos, F && callback,
    const SubscriptionOptions & options = {})
  {
    auto made = std::make_shared<GenericSubscription>(type);
    made->call_back(std::forward<F>(callback));
    detail::make_subscription(*base_, made, type, extended(topic), qos, options);
    return made;
  }

  // -- timers

  template<class Rep, class Period, class F>
  TimerBase::SharedPtr create_wall_timer(
    std::chrono::duration<Rep, Period> period, F callback, CallbackGroup::SharedPtr group = nullptr)
  {
    return detail::timer(*base_, detail::timer_period(period), std::move(callback), group, nullptr);
  }
  template<class Rep, class Period, class F>
  TimerBase::SharedPtr create_timer(
    std::chrono::duration<Rep, Period> period, F callback, CallbackGroup::SharedPtr group = nullptr)
  {
    return detail::timer(*base_, detail::timer_period(period), std::move(callback), group, base_->clock);
  }

  // -- services

  template<class S, class F>
  typename Service<S>::SharedPtr create_service(
    const std::string & name, F && callback, const rmw_qos_profile_t & profile = rmw_qos_profile_services_default,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_service<S>(name, std::forward<F>(callback), QoS(QoSInitialization::from_rmw(profile), profile), group);
  }
  template<class S, class F>
  typename Service<S>::SharedPtr create_service(
    const std::string & name, F && callback, const QoS & qos, CallbackGroup::SharedPtr group = nullptr)
  {
    return detail::service<S>(*base_, extended(name), std::forward<F>(callback), qos, group);
  }
  template<class S>
  typename Client<S>::SharedPtr create_client(
    const std::string & name, const rmw_qos_profile_t & profile = rmw_qos_profile_services_default,
    CallbackGroup::SharedPtr group = nullptr)
  {
    return create_client<S>(name, QoS(QoSInitialization::from_rmw(profile), profile), group);
  }
  template<class S>
  typename Client<S>::SharedPtr create_client(
    const std::string & name, const QoS & qos, CallbackGroup::SharedPtr group = nullptr)
  {
    return detail::client<S>(*base_, extended(name), qos, group);
  }

  // -- parameters

  const ParameterValue & declare_parameter(
    const std::string & name, const ParameterValue & default_value, const Descriptor & descriptor = Descriptor(),
    bool ignore_override = false)
  {
    return base_->declare_parameter(name, default_value, descriptor, ignore_override);
  }
  const ParameterValue & declare_parameter(
    const std::string & name, ParameterType type, const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    return base_->declare_parameter(name, type, descriptor, ignore_override);
  }
  template<class T>
  auto declare_parameter(
    const std::string & name, const T & default_value,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    using Value = std::conditional_t<std::is_convertible_v<T, const char *>, std::string, T>;
    return Value(declare_parameter(name, ParameterValue(Value(default_value)), descriptor, ignore_override).template get<Value>());
  }
  template<class T>
  auto declare_parameter(
    const std::string & name,
    const Descriptor & descriptor = Descriptor(), bool ignore_override = false)
  {
    ParameterValue value = declare_parameter(name, detail::ParameterKind<T>::type, descriptor, ignore_override);
    if (value.get_type() == PARAMETER_NOT_SET) {
      throw exceptions::UninitializedStaticallyTypedParameterException(
              "Statically typed parameter '" + name + "' must be initialized.");
    }
    return T(value.template get<T>());
  }
  template<class T>
  std::vector<T> declare_parameters(
    const std::string & space, const std::map<std::string, T> & parameters, bool ignore_overrides = false)
  {
    std::vector<T> values;
    for (auto & [key, value] : parameters) {
      values.push_back(declare_parameter(space.empty() ? key : space + "." + key, value, Descriptor(), ignore_overrides));
    }
    return values;
  }
  template<class T>
  std::vector<T> declare_parameters(
    const std::string & space,
    const std::map<std::string, std::pair<T, Descriptor>> & parameters,
    bool ignore_overrides = false)
  {
    std::vector<T> values;
    for (auto & [key, pair] : parameters) {
      values.push_back(
        declare_parameter(space.empty() ? key : space + "." + key, pair.first, pair.second, ignore_overrides));
    }
    return values;
  }
  void undeclare_parameter(const std::string & name) {base_->undeclare_parameter(name);}
  bool has_parameter(const std::string & name) const {return base_->has_parameter(name);}
  Parameter get_parameter(const std::string & name) const {return base_->get_parameter(name);}
  bool get_parameter(const std::string & name, Parameter & parameter) const {return base_->get_parameter(name, parameter);}
  /// Not inlined: the compiler would warn of a variable that stays as it was where the parameter is not there.
  template<class T>
  __attribute__((noinline)) bool get_parameter(const std::string & name, T & value) const
  {
    Parameter found;
    bool known = get_parameter(name, found) && found.get_type() != PARAMETER_NOT_SET;
    if (known) {
      value = static_cast<T>(found.get_value<T>());
    }
    return known;
  }
  template<class T>
  bool get_parameter_or(const std::string & name, T & value, const T & alternative) const
  {
    bool known = get_parameter(name, value);
    if (!known) {
      value = alternative;
    }
    return known;
  }
  template<class T>
  T get_parameter_or(const std::string & name, const T & alternative) const
  {
    T value;
    get_parameter_or(name, value, alternative);
    return value;
  }
  std::vector<Parameter> get_parameters(const std::vector<std::string> & names) const {return base_->get_parameters(names);}
  template<class T>
  bool get_parameters(const std::string & prefix, std::map<std::string, T> & values) const
  {
    std::map<std::string, Parameter> found;
    bool any = base_->get_parameters_by_prefix(prefix, found);
    for (auto & [name, parameter] : found) {
      values[name] = static_cast<T>(parameter.template get_value<T>());
    }
    return any;
  }
  rcl_interfaces::msg::SetParametersResult set_parameter(const Parameter & parameter) {return base_->set_parameter(parameter);}
  std::vector<rcl_interfaces::msg::SetParametersResult> set_parameters(const std::vector<Parameter> & parameters)
  {
    return base_->set_parameters(parameters);
  }
  rcl_interfaces::msg::SetParametersResult set_parameters_atomically(const std::vector<Parameter> & parameters)
  {
    return base_->set_parameters_atomically(parameters);
  }
  Descriptor describe_parameter(const std::string & name) const {return base_->describe_parameter(name);}
  std::vector<Descriptor> describe_parameters(const std::vector<std::string> & names) const
  {
    return base_->describe_parameters(names);
  }
  std::vector<uint8_t> get_parameter_types(const std::vector<std::string> & names) const
  {
    return base_->get_parameter_types(names);
  }
  rcl_interfaces::msg::ListParametersResult list_parameters(const std::vector<std::string> & prefixes, uint64_t depth) const
  {
    return base_->list_parameters(prefixes, depth);
  }
  using OnSetParametersCallbackHandle = node_interfaces::OnSetParametersCallbackHandle;
  using OnParametersSetCallbackType = OnSetParametersCallbackHandle::OnParametersSetCallbackType;
  OnSetParametersCallbackHandle::SharedPtr add_on_set_parameters_callback(OnParametersSetCallbackType callback)
  {
    return base_->add_on_set_parameters_callback(std::move(callback));
  }
  void remove_on_set_parameters_callback(const OnSetParametersCallbackHandle * handle)
  {
    base_->remove_on_set_parameters_callback(handle);
  }

  // -- the graph

  using NamesAndTypes = std::map<std::string, std::vector<std::string>>;
  std::vector<std::string> get_node_names() const {return base_->get_node_names();}
  NamesAndTypes get_topic_names_and_types() const {return base_->get_topic_names_and_types();}
  NamesAndTypes get_service_names_and_types() const {return base_->get_service_names_and_types();}
  size_t count_publishers(const std::string & topic) const {return base_->count_publishers(topic);}
  size_t count_subscribers(const std::string & topic) const {return base_->count_subscribers(topic);}
  NamesAndTypes get_service_names_and_types_by_node(const std::string & name, const std::string & space) const
  {
    return base_->get_service_names_and_types_by_node(name, space);
  }
  std::vector<TopicEndpointInfo> get_publishers_info_by_topic(const std::string & topic, bool no_mangle = false) const
  {
    return base_->get_publishers_info_by_topic(topic, no_mangle);
  }
  std::vector<TopicEndpointInfo> get_subscriptions_info_by_topic(const std::string & topic, bool no_mangle = false) const
  {
    return base_->get_subscriptions_info_by_topic(topic, no_mangle);
  }
  Event::SharedPtr get_graph_event() {return base_->get_graph_event();}
  void wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout)
  {
    base_->wait_for_graph_change(event, timeout);
  }

protected:
  NodeFace(const NodeFace & other, const std::string & sub_namespace);
  /// A name below the sub-namespace of a sub-node; absolute and private names stay.
  std::string extended(const std::string & name) const;
  NodeBase::SharedPtr base_;

private:
  std::string sub_namespace_;
  NodeOptions options_;
};

class Node : public NodeFace, public std::enable_shared_from_this<Node>
{
public:
  RCLCPP_SMART_PTR_DEFINITIONS(Node)
  explicit Node(const std::string & name, const NodeOptions & options = NodeOptions())
  : Node(name, "", options) {}
  explicit Node(const std::string & name, const std::string & space, const NodeOptions & options = NodeOptions())
  : NodeFace(name, space, options, false) {}
  /// The same node, whose relative names are below a sub-namespace.
  SharedPtr create_sub_node(const std::string & sub_namespace) {return SharedPtr(new Node(*this, sub_namespace));}

protected:
  Node(const Node & other, const std::string & sub_namespace)
  : NodeFace(other, sub_namespace) {}
};

namespace detail
{
template<class N, class = void>
struct HasBaseInterface : std::false_type {};
template<class N>
struct HasBaseInterface<N, std::void_t<decltype(std::declval<N &>().get_node_base_interface())>> : std::true_type {};
}  // namespace detail
/// The node, given as itself or as any kind of pointer to it; also a program's own class that has a node's interfaces.
template<class N>
auto & node_of(N && node)
{
  if constexpr (detail::HasBaseInterface<std::decay_t<N>>::value) {
    return node;
  } else {
    return *node;
  }
}
/// The interface of a node that is given as itself, as a pointer to it, or as that interface.
template<class N>
node_interfaces::NodeBaseInterface::SharedPtr base_of(N && node)
{
  if constexpr (std::is_convertible_v<N, node_interfaces::NodeBaseInterface::SharedPtr>) {
    return node;
  } else if constexpr (std::is_convertible_v<N, node_interfaces::NodeBaseInterface *>) {
    return {node_interfaces::NodeBaseInterface::SharedPtr(), node};  // who gives a bare pointer keeps the node
  } else {
    return node_of(node).get_node_base_interface();
  }
}
namespace node_interfaces
{
template<class N>
NodeBaseInterface::SharedPtr get_node_base_interface(N && node) {return base_of(node);}
template<class N>
NodeTimersInterface::SharedPtr get_node_timers_interface(N && node) {return base_of(node);}
template<class N>
NodeTopicsInterface::SharedPtr get_node_topics_interface(N && node) {return base_of(node);}
}  // namespace node_interfaces
}  // namespace rclcpp
