// Nodes and their entities: how each is entered at the session.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
using node_interfaces::NodeBaseInterface;

/// What the session says about a node: its number, its names, and its group.
static void take_facts(NodeBaseInterface & node, Unpacker answer)
{
  node.id = answer.i();
  node.name = answer.s();
  node.space = answer.s();
  node.full_name = answer.s();
  node.logger = Logger(answer.s());
  node.group = std::make_shared<CallbackGroup>(answer.i(), CallbackGroupType::MutuallyExclusive);
  node.enter(node.group);
  node.clock = std::make_shared<Clock>(RCL_ROS_TIME, node.id);
}
NodeFace::NodeFace(const std::string & name, const std::string & space, const NodeOptions & options, bool lifecycle)
: base_(std::make_shared<NodeBase>()), options_(options)
{
  Packer with = Packer{}.s(name).s(space).i(lifecycle).i(options.use_global_arguments());
  with.i(options.allow_undeclared_parameters()).i(options.automatically_declare_parameters_from_overrides());
  with.i(options.enable_rosout()).i(options.start_parameter_services());
  base_->context = options.context();
  with.i(base_->context->number()).i(static_cast<int64_t>(options.arguments().size()));
  for (auto & word : options.arguments()) {
    with.s(word);
  }
  auto & overrides = static_cast<const NodeOptions &>(options).parameter_overrides();
  with.i(static_cast<int64_t>(overrides.size()));
  for (auto & parameter : overrides) {
    with.m(parameter.to_parameter_msg());
    base_->overrides[parameter.get_name()] = parameter.get_parameter_value();
  }
  take_facts(*base_, ask("node", with));
  base_->topic_statistics = options.enable_topic_statistics();
  base_->intra_process = options.use_intra_process_comms();
}
NodeFace::NodeFace(SharedNode node)
: base_(std::make_shared<NodeBase>()), options_()
{
  base_->context = options_.context();
  take_facts(*base_, ask("shared_node", Packer{}.i(node.id)));
}
// -- QoS: events, and policies that parameters override

QoSCheckCompatibleResult qos_check_compatible(const QoS & publisher, const QoS & subscription)
{
  Packer with;
  publisher.pack(with);
  subscription.pack(with);
  Unpacker answer = ask("qos_check", with);
  auto verdict = static_cast<QoSCompatibility>(answer.i());
  return {verdict, answer.s()};
}

namespace
{
/// The number of the handler that the session calls for an event; 0 where nobody listens to it.
template<class Owner, class Type>
void pack_event(Owner & owner, Type event, Packer & with)
{
  auto found = owner.events.find(event);
  if (found == owner.events.end()) {
    with.i(0);
    return;
  }
  with.i(owner.handle([call = found->second->call()](Unpacker & from, Packer &) {call(from);}));
}
void pack_overriding(const QosOverridingOptions & options, coursekit::Entity & owner, Packer & with)
{
  with.s(options.get_id()).i(static_cast<int64_t>(options.get_policy_kinds().size()));
  for (auto kind : options.get_policy_kinds()) {
    with.i(static_cast<int64_t>(kind));
  }
  auto judge = options.get_validation_callback();
  if (!judge) {
    with.i(0);
    return;
  }
  with.i(owner.handle(
      [judge](Unpacker & from, Packer & to) {
        QosCallbackResult result = judge(QoS::unpack(from));
        to.i(result.successful).s(result.reason);
      }));
}
}  // namespace

/// Whether messages may stay in the program; throws std::invalid_argument for a QoS that does not allow it.
static bool stays_in_program(IntraProcessSetting setting, const detail::NodeBase & node, const QoS & qos)
{
  if (setting == IntraProcessSetting::Disable || (setting == IntraProcessSetting::NodeDefault && !node.intra_process)) {
    return false;
  }
  if (qos.history() == HistoryPolicy::KeepAll) {
    throw std::invalid_argument("intraprocess communication is not allowed with keep all history qos policy");
  }
  if (qos.depth() == 0) {
    throw std::invalid_argument("intraprocess communication is not allowed with a zero qos history depth value");
  }
  if (qos.durability() != DurabilityPolicy::Volatile) {
    throw std::invalid_argument("intraprocess communication allowed only with volatile durability");
  }
  return true;
}

void detail::make_publisher(
  NodeBase & node, PublisherBase & made, const std::string & type, const std::string & topic, const QoS & qos,
  const PublisherOptionsBase & options)
{
  if (options.require_unique_network_flow_endpoints == RMW_UNIQUE_NETWORK_FLOW_ENDPOINTS_STRICTLY_REQUIRED) {
    // as Humble's middleware, which has such flows for subscriptions alone
    throw exceptions::RCLError("could not create publisher: Unique network flow endpoints not supported on publishers");
  }
  Packer with = Packer{}.i(node.id).s(type).s(topic).i(number_of(options.callback_group));
  qos.pack(with);
  detail::listen_to_events(node, made, options);
  for (auto event : {RCL_PUBLISHER_OFFERED_DEADLINE_MISSED, RCL_PUBLISHER_LIVELINESS_LOST, RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS}) {
    pack_event(made, event, with);
  }
  pack_overriding(options.qos_overriding_options, made, with);
  Unpacker answer = ask("publisher", with);
  made.id = answer.i();
  made.name = answer.s();
  made.qos = QoS::unpack(answer);
  made.context = node.context;
  made.intra_process = stays_in_program(options.use_intra_process_comm, node, made.qos);
  if (made.intra_process) {
    coursekit::note("stays", Packer{}.i(made.id));
  }
  std::string gid = answer.s();
  std::copy_n(gid.begin(), std::min(gid.size(), sizeof(made.gid.data)), made.gid.data);
  made.gid.implementation_identifier = "coursekit";
}
void PublisherBase::prepare(
  const node_interfaces::NodeBaseInterface & node, const std::string & type, const std::string & topic, const QoS & wanted,
  const PublisherOptionsBase & options)
{
  name = node.resolve_topic_name(topic);
  qos = wanted;
  entering = [this, type, topic, wanted, options = options](detail::NodeBase & taker, CallbackGroup::SharedPtr group) mutable {
      options.callback_group = group;
      detail::make_publisher(taker, *this, type, topic, wanted, options);
    };
}
void SubscriptionBase::prepare(
  const node_interfaces::NodeBaseInterface & node, const std::string & type, const std::string & topic, const QoS & wanted,
  const SubscriptionOptionsBase & options)
{
  name = node.resolve_topic_name(topic);
  qos = wanted;
  entering = [this, type, topic, wanted, options = options](detail::NodeBase & taker, CallbackGroup::SharedPtr group) mutable {
      options.callback_group = group;
      detail::make_subscription(taker, shared_from_this(), type, topic, wanted, options);
    };
}
PublisherBase::SharedPtr detail::NodeBase::create_publisher(
  const std::string & topic, const PublisherFactory & factory, const QoS & wanted)
{
  return factory.create_typed_publisher(this, topic, wanted);
}
SubscriptionBase::SharedPtr detail::NodeBase::create_subscription(
  const std::string & topic, const SubscriptionFactory & factory, const QoS & wanted)
{
  return factory.create_typed_subscription(this, topic, wanted);
}
/// Take in what a program constructed, once.
template<class E>
static void take_in(detail::NodeBase & node, E & made, const CallbackGroup::SharedPtr & group, const char * refusal)
{
  if (group && !node.callback_group_in_node(group)) {
    throw std::runtime_error(refusal);
  }
  if (auto enter = std::exchange(made.entering, nullptr)) {
    enter(node, group);
  }
}
void detail::NodeBase::add_publisher(PublisherBase::SharedPtr publisher, CallbackGroup::SharedPtr wanted)
{
  take_in(*this, *publisher, wanted, "Cannot create publisher, callback group not in node.");
}
void detail::NodeBase::add_subscription(SubscriptionBase::SharedPtr subscription, CallbackGroup::SharedPtr wanted)
{
  take_in(*this, *subscription, wanted, "Cannot create subscription, callback group not in node.");
}

void detail::make_subscription(
  NodeBase & node, const SubscriptionBase::SharedPtr & made, const std::string & type, const std::string & topic,
  const QoS & qos, const SubscriptionOptionsBase & options)
{
  std::weak_ptr<SubscriptionBase> weak = made;
  int64_t handler = made->handle(
    [weak](Unpacker & from, Packer &) {
      MessageInfo info;
      SubscriptionBase::unpack_info(from, info);
      if (auto me = weak.lock()) {
        me->dispatch(from.rest(), info);
      }
    });
  Packer with = Packer{}.i(node.id).s(type).s(topic).i(handler).i(number_of(options.callback_group));
  qos.pack(with);
  detail::listen_to_events(node, *made, options);
  for (auto event : {RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED, RCL_SUBSCRIPTION_LIVELINESS_CHANGED,
      RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS, RCL_SUBSCRIPTION_MESSAGE_LOST})
  {
    pack_event(*made, event, with);
  }
  with.i(options.ignore_local_publications);
  pack_overriding(options.qos_overriding_options, *made, with);
  auto & statistics = options.topic_stats_options;
  bool node_wants = statistics.state == TopicStatisticsState::NodeDefault && node.topic_statistics;
  with.i(statistics.state == TopicStatisticsState::Enable || node_wants).s(statistics.publish_topic);
  with.i(std::chrono::nanoseconds(statistics.publish_period).count());
  Unpacker answer = ask("subscription", with);
  made->id = answer.i();
  made->name = answer.s();
  made->qos = QoS::unpack(answer);
  enlist(node, options.callback_group, made);
  bool stays = stays_in_program(options.use_intra_process_comm, node, made->qos);
  if (stays && made->taken_type && !options.ignore_local_publications) {
    made->inbox = std::make_shared<intra_process::Inbox>(made->name, *made->taken_type, made->owns, made->qos.depth());
    intra_process::enter(made->inbox);
    coursekit::note("stays", Packer{}.i(made->id));
  }
  auto & filter = options.content_filter_options;
  if (!filter.filter_expression.empty()) {
    made->set_content_filter(filter.filter_expression, filter.expression_parameters);
  }
}
void NodeBaseInterface::add_timer(TimerBase::SharedPtr timer, CallbackGroup::SharedPtr in)
{
  if (in && !callback_group_in_node(in)) {
    throw std::runtime_error("Cannot create timer, group not in node.");
  }
  detail::make_timer(*this, timer, in);
}
void detail::make_timer(NodeBase & node, const TimerBase::SharedPtr & made, const CallbackGroup::SharedPtr & group)
{
  if (made->period.count() < 0) {
    throw std::invalid_argument("timer period cannot be negative");
  }
  std::weak_ptr<TimerBase> weak = made;
  int64_t handler = made->handle(
    [weak](Unpacker &, Packer &) {
      if (auto me = weak.lock()) {
        me->callback();
      }
    });
  rcl_clock_type_t kind = made->clock ? made->clock->get_clock_type() : RCL_STEADY_TIME;
  made->steady = kind == RCL_STEADY_TIME;
  made->id = ask("timer", Packer{}.i(node.id).i(made->period.count()).i(kind).i(handler).i(number_of(group))).i();
  enlist(node, group, made);
}

// -- sub-nodes

NodeFace::NodeFace(const NodeFace & other, const std::string & sub_namespace)
: base_(other.base_), options_(other.options_)
{
  auto refuse = [&](const char * why) {
      throw exceptions::NameValidationError("sub_namespace", sub_namespace.c_str(), why, 0);
    };
  if (sub_namespace.empty()) {
    refuse("sub-nodes should not extend nodes by an empty sub-namespace");
  }
  if (sub_namespace.front() == '/') {
    refuse("a sub-namespace should not have a leading /");
  }
  sub_namespace_ = other.sub_namespace_.empty() ? sub_namespace : other.sub_namespace_ + "/" + sub_namespace;
  expand_topic_or_service_name("name", get_name(), get_effective_namespace());  // throws InvalidNamespaceError
}
std::string NodeFace::extended(const std::string & name) const
{
  bool relative = !name.empty() && name.front() != '/' && name.front() != '~';
  return sub_namespace_.empty() || !relative ? name : sub_namespace_ + "/" + name;
}
std::string NodeFace::get_effective_namespace() const
{
  std::string space = get_namespace();
  return sub_namespace_.empty() ? space : (space.back() == '/' ? space : space + "/") + sub_namespace_;
}
}  // namespace rclcpp
