// The topics of the graph in a bag.
#include "rosbag2_transport/recorder.hpp"

#include "bag_qos.hpp"
#include "rosbag2_interfaces/srv/snapshot.hpp"

namespace rosbag2_transport
{
namespace
{
bool is_hidden(const std::string & name) {return name.find("/_") != name.npos || name.compare(0, 1, "_") == 0;}
bool matches(const std::string & expression, const std::string & name)
{
  return !expression.empty() && std::regex_search(name, std::regex(expression));
}
}  // namespace

Recorder::Recorder(const std::string & node_name, const rclcpp::NodeOptions & node_options)
: Node(node_name, node_options) {}
Recorder::Recorder(
  std::shared_ptr<rosbag2_cpp::Writer> writer, const rosbag2_storage::StorageOptions & storage_options,
  const RecordOptions & record_options, const std::string & node_name, const rclcpp::NodeOptions & node_options)
: Node(node_name, node_options), writer_(std::move(writer)), storage_options_(storage_options),
  record_options_(record_options), paused_(record_options.start_paused)
{
  if (record_options.use_sim_time) {
    set_parameter(rclcpp::Parameter("use_sim_time", true));
  }
  for (const std::string & topic : record_options.topics) {
    requested_.insert(rclcpp::expand_topic_or_service_name(topic, get_name(), get_namespace()));
  }
}
Recorder::~Recorder() = default;

void Recorder::record()
{
  if (record_options_.rmw_serialization_format.empty()) {
    throw std::runtime_error("No serialization format specified!");
  }
  writer_->open(storage_options_, {rmw_get_serialization_format(), record_options_.rmw_serialization_format});
  if (storage_options_.snapshot_mode) {
    using rosbag2_interfaces::srv::Snapshot;
    snapshot_ = create_service<Snapshot>(
      "~/snapshot", [this](const Snapshot::Request::SharedPtr, Snapshot::Response::SharedPtr response) {
        response->success = writer_->take_snapshot();
      });
  }
  RCLCPP_INFO(get_logger(), "Listening for topics...");
  if (record_options_.use_sim_time) {
    RCLCPP_INFO(get_logger(), "use_sim_time set, waiting for /clock before starting recording...");
  }
  if (!record_options_.is_discovery_disabled) {
    discovery_ = create_wall_timer(record_options_.topic_polling_interval, [this] {discover();});
  }
  discover();
  RCLCPP_INFO(get_logger(), "%s", paused_ ? "Waiting for recording: Press SPACE to start." : "Recording...");
}
void Recorder::stop()
{
  if (discovery_) {
    discovery_->cancel();
  }
  subscriptions_.clear();
  writer_->close();
  RCLCPP_INFO(get_logger(), "Recording stopped");
}
void Recorder::pause()
{
  paused_ = true;
  RCLCPP_INFO(get_logger(), "Pausing recording.");
}
void Recorder::resume()
{
  paused_ = false;
  RCLCPP_INFO(get_logger(), "Resuming recording.");
}
void Recorder::toggle_paused() {paused_ ? resume() : pause();}

void Recorder::discover()
{
  if (record_options_.use_sim_time && get_clock()->now().nanoseconds() == 0) {
    return;
  }
  for (const auto & [name, types] : get_topic_names_and_types()) {
    if (subscriptions_.count(name)) {
      warn_of_new_publishers(name);
    } else if (takes(name, types)) {
      subscribe(name, types[0]);
    }
  }
  const bool only_these = !requested_.empty() && record_options_.regex.empty() && !record_options_.all;
  if (discovery_ && !discovery_->is_canceled() && only_these && subscriptions_.size() == requested_.size()) {
    RCLCPP_INFO(get_logger(), "All requested topics are subscribed. Stopping discovery...");
    discovery_->cancel();
  }
}
bool Recorder::takes(const std::string & name, const std::vector<std::string> & types)
{
  const RecordOptions & options = record_options_;
  if (!requested_.count(name) && !options.all && !matches(options.regex, name)) {
    return false;
  }
  const size_t published = count_publishers(name), heard = count_subscribers(name);
  if (matches(options.exclude, name) || (!published && !options.include_unpublished_topics) ||
    (options.ignore_leaf_topics && !(published && heard)))
  {
    return false;
  }
  if (is_hidden(name) && !options.include_hidden_topics) {
    return refuse("hidden", "Hidden topics are not recorded. Enable them with --include-hidden-topics");
  }
  if (types.size() != 1) {
    return refuse(name, "Topic '" + name + "' has several types associated. Only topics with one type are supported");
  }
  return !refused_.count(name);
}
bool Recorder::refuse(const std::string & key, const std::string & text)
{
  if (refused_.insert(key).second) {
    RCLCPP_WARN(get_logger(), "%s", text.c_str());
  }
  return false;
}
void Recorder::subscribe(const std::string & name, const std::string & type)
{
  std::vector<rclcpp::QoS> offers;
  for (const auto & info : get_publishers_info_by_topic(name)) {
    offers.push_back(info.qos_profile());
  }
  auto chosen = record_options_.topic_qos_profile_overrides.find(name);
  const bool own = chosen != record_options_.topic_qos_profile_overrides.end();
  if (own) {
    RCLCPP_INFO(get_logger(), "Overriding subscription profile for %s", name.c_str());
  }
  try {
    writer_->create_topic({name, type, record_options_.rmw_serialization_format, offers_text(offers)});
    subscriptions_[name] = create_generic_subscription(
      name, type, own ? chosen->second : request_for(name, offers),
      [this, name, type](std::shared_ptr<rclcpp::SerializedMessage> message) {keep(name, type, *message);});
  } catch (const std::exception & error) {
    refuse(
      name, "Topic '" + name + "' has unknown type '" + type + "' associated. Only topics with known type are supported. "
      "Reason: '" + error.what() + "'");
    return;
  }
  RCLCPP_INFO(get_logger(), "Subscribed to topic '%s'", name.c_str());
}
void Recorder::keep(const std::string & name, const std::string & type, const rclcpp::SerializedMessage & message)
{
  if (!paused_) {
    writer_->write(message, name, type, get_clock()->now());
  }
}
void Recorder::warn_of_new_publishers(const std::string & name)
{
  const rclcpp::QoS used = subscriptions_[name]->get_actual_qos();
  const auto misses = [&](const char * offered, const char * asked) {
      if (topics_warned_about_incompatibility_.insert(name).second) {
        RCLCPP_WARN(
          get_logger(), "A new publisher for subscribed topic %s was found offering RMW_QOS_POLICY_%s, but rosbag already "
          "subscribed requesting RMW_QOS_POLICY_%s. Messages from this new publisher will not be recorded.", name.c_str(),
          offered, asked);
      }
    };
  for (const auto & info : get_publishers_info_by_topic(name)) {
    const rclcpp::QoS & offer = info.qos_profile();
    if (offer.reliability() == rclcpp::ReliabilityPolicy::BestEffort && used.reliability() == rclcpp::ReliabilityPolicy::Reliable) {
      misses("RELIABILITY_BEST_EFFORT", "RELIABILITY_RELIABLE");
    } else if (offer.durability() == rclcpp::DurabilityPolicy::Volatile &&
      used.durability() == rclcpp::DurabilityPolicy::TransientLocal)
    {
      misses("DURABILITY_VOLATILE", "DURABILITY_TRANSIENT_LOCAL");
    }
  }
}
}  // namespace rosbag2_transport
