// What a node asks of the session about itself and about the others: names, callback groups, who is in the graph.
#include "rclcpp/rclcpp.hpp"

namespace rclcpp
{
using node_interfaces::NodeBaseInterface;

NodeBaseInterface::~NodeBaseInterface()
{
  if (clock) {
    clock->follow(0);  // it may outlive its node
  }
  if (id) {
    coursekit::note("drop", Packer{}.i(id));
  }
}

// -- callback groups

CallbackGroup::SharedPtr NodeBaseInterface::create_callback_group(CallbackGroupType type, bool automatic)
{
  bool reentrant = type == CallbackGroupType::Reentrant;
  int64_t number = ask("callback_group", Packer{}.i(id).i(reentrant).i(automatic)).i();
  auto made = std::make_shared<CallbackGroup>(number, type, automatic);
  enter(made);
  return made;
}
void NodeBaseInterface::enter(const CallbackGroup::SharedPtr & made)
{
  std::lock_guard<std::mutex> hold(lock_);
  groups_.push_back(made);
}
void NodeBaseInterface::for_each_callback_group(const std::function<void (CallbackGroup::SharedPtr)> & visit)
{
  std::vector<CallbackGroup::WeakPtr> all;
  {
    std::lock_guard<std::mutex> hold(lock_);
    all = groups_;
  }
  for (auto & weak : all) {
    if (auto one = weak.lock()) {
      visit(one);
    }
  }
}
bool NodeBaseInterface::callback_group_in_node(CallbackGroup::SharedPtr wanted)
{
  bool found = false;
  for_each_callback_group([&](CallbackGroup::SharedPtr one) {found = found || one == wanted;});
  return found;
}

// -- names

std::string NodeBaseInterface::resolve_topic_name(const std::string & topic, bool only_expand) const
{
  return ask("resolve_topic", Packer{}.i(id).s(topic).i(only_expand)).s();
}
std::string NodeBaseInterface::resolve_service_name(const std::string & service, bool only_expand) const
{
  return ask("resolve_service", Packer{}.i(id).s(service).i(only_expand)).s();
}
std::string NodeBaseInterface::resolve_topic_or_service_name(
  const std::string & name, bool is_service, bool only_expand) const
{
  return is_service ? resolve_service_name(name, only_expand) : resolve_topic_name(name, only_expand);
}
std::string expand_topic_or_service_name(
  const std::string & name, const std::string & node_name, const std::string & space, bool is_service)
{
  return ask("expand_name", Packer{}.s(name).s(node_name).s(space).i(is_service)).s();
}

// -- the graph

std::vector<std::string> NodeBaseInterface::get_node_names() const
{
  return ask("node_names", Packer{}.i(id)).texts();
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::names_and_types(const char * what, const Packer & with) const
{
  Unpacker answer = ask(what, with);
  NamesAndTypes all;
  for (int64_t count = answer.i(); count > 0; --count) {
    std::string name = answer.s();
    all[name] = answer.texts();
  }
  return all;
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_topic_names_and_types(bool) const
{
  return names_and_types("topics", Packer{}.i(id));
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_service_names_and_types() const
{
  return names_and_types("services", Packer{}.i(id));
}
size_t NodeBaseInterface::count_publishers(const std::string & topic) const
{
  return static_cast<size_t>(ask("count_publishers", Packer{}.i(id).s(topic)).i());
}
size_t NodeBaseInterface::count_subscribers(const std::string & topic) const
{
  return static_cast<size_t>(ask("count_subscribers", Packer{}.i(id).s(topic)).i());
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::ends_of(
  const char * which, const std::string & name, const std::string & space) const
{
  return names_and_types("ends_of", Packer{}.i(id).s(which).s(name).s(space));
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_service_names_and_types_by_node(
  const std::string & name, const std::string & space) const
{
  return ends_of("service", name, space);
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_client_names_and_types_by_node(
  const std::string & name, const std::string & space) const
{
  return ends_of("client", name, space);
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_publisher_names_and_types_by_node(
  const std::string & name, const std::string & space, bool) const
{
  return ends_of("publisher", name, space);
}
NodeBaseInterface::NamesAndTypes NodeBaseInterface::get_subscriber_names_and_types_by_node(
  const std::string & name, const std::string & space, bool) const
{
  return ends_of("subscriber", name, space);
}
std::vector<TopicEndpointInfo> NodeBaseInterface::endpoints(const char * what, const std::string & topic, bool no_mangle) const
{
  if (!no_mangle) {
    expand_topic_or_service_name(topic, name, space);  // throws where it is no name of a topic
  }
  Unpacker answer = ask(what, Packer{}.i(id).s(topic).i(no_mangle));
  std::vector<TopicEndpointInfo> all;
  for (int64_t count = answer.i(); count > 0; --count) {
    all.emplace_back(answer);
  }
  return all;
}
std::vector<TopicEndpointInfo> NodeBaseInterface::get_publishers_info_by_topic(const std::string & topic, bool no_mangle) const
{
  return endpoints("publishers_info", topic, no_mangle);
}
std::vector<TopicEndpointInfo> NodeBaseInterface::get_subscriptions_info_by_topic(const std::string & topic, bool no_mangle) const
{
  return endpoints("subscriptions_info", topic, no_mangle);
}
Event::SharedPtr NodeBaseInterface::get_graph_event()
{
  auto event = Event::make_shared();
  graph_seen_[event.get()] = ask("graph_changes", Packer{}.i(id)).i();
  return event;
}
void NodeBaseInterface::wait_for_graph_change(Event::SharedPtr event, std::chrono::nanoseconds timeout)
{
  if (!event) {
    throw exceptions::InvalidEventError();
  }
  auto seen = graph_seen_.find(event.get());
  if (seen == graph_seen_.end()) {
    throw exceptions::EventNotRegisteredError();
  }
  int64_t now = ask("wait_for_graph", Packer{}.i(id).i(seen->second).i(timeout.count())).i();
  if (now != seen->second) {
    seen->second = now;
    event->set();
  }
}
std::vector<std::pair<std::string, std::string>> NodeBaseInterface::get_node_names_and_namespaces() const
{
  std::vector<std::pair<std::string, std::string>> all;
  for (auto & full : get_node_names()) {
    size_t slash = full.rfind('/');
    all.emplace_back(full.substr(slash + 1), slash ? full.substr(0, slash) : "/");
  }
  return all;
}
std::vector<std::tuple<std::string, std::string, std::string>> NodeBaseInterface::get_node_names_with_enclaves() const
{
  std::vector<std::tuple<std::string, std::string, std::string>> all;
  for (auto & [node, space] : get_node_names_and_namespaces()) {
    all.emplace_back(node, space, "/");  // nothing is encrypted, so that all are in one enclave
  }
  return all;
}
}  // namespace rclcpp
