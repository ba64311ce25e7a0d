// A bag's messages at the times at which they were recorded.
#include "rosbag2_transport/player.hpp"

#include <cmath>

#include "bag_qos.hpp"
#include "rosbag2_transport/reader_writer_factory.hpp"
#include "rosgraph_msgs/msg/clock.hpp"

namespace rosbag2_transport
{
namespace
{
constexpr int64_t LONGEST_WAIT_NS = 10000000;  // then it is looked whether somebody paused, or all has ended
rclcpp::NodeOptions with_remappings(rclcpp::NodeOptions options, const PlayOptions & play_options)
{
  if (!play_options.topic_remapping_options.empty()) {
    options.arguments(play_options.topic_remapping_options);
  }
  return options;
}
}  // namespace

Player::Player(const std::string & node_name, const rclcpp::NodeOptions & node_options)
: Node(node_name, node_options) {}
Player::Player(
  const rosbag2_storage::StorageOptions & storage_options, const PlayOptions & play_options, const std::string & node_name,
  const rclcpp::NodeOptions & node_options)
: Player(ReaderWriterFactory::make_reader(storage_options), storage_options, play_options, node_name, node_options) {}
Player::Player(
  std::unique_ptr<rosbag2_cpp::Reader> reader, const rosbag2_storage::StorageOptions & storage_options,
  const PlayOptions & play_options, const std::string & node_name, const rclcpp::NodeOptions & node_options)
: Node(node_name, with_remappings(node_options, play_options)), reader_(std::move(reader)), storage_options_(storage_options),
  play_options_(play_options), paused_(play_options.start_paused)
{
  reader_->open(storage_options_);
  start_ = reader_->get_metadata().starting_time.time_since_epoch().count() + std::max<int64_t>(0, play_options.start_offset);
  jump(start_);
  set_rate(play_options.rate);
  make_publishers();
  make_services();
  publish_clock();
}
Player::~Player() = default;

void Player::make_publishers()
{
  rosbag2_storage::StorageFilter filter;
  filter.topics = play_options_.topics_to_filter;
  for (std::string & topic : filter.topics) {
    topic = rclcpp::expand_topic_or_service_name(topic, get_name(), get_namespace());
  }
  filter.topics_regex = play_options_.topics_regex_to_filter;
  filter.topics_regex_to_exclude = play_options_.topics_regex_to_exclude;
  reader_->set_filter(filter);
  for (const auto & topic : reader_->get_all_topics_and_types()) {
    if (!filter.topics.empty() && std::find(filter.topics.begin(), filter.topics.end(), topic.name) == filter.topics.end()) {
      continue;
    }
    auto chosen = play_options_.topic_qos_profile_overrides.find(topic.name);
    const bool own = chosen != play_options_.topic_qos_profile_overrides.end();
    if (own) {
      RCLCPP_INFO(get_logger(), "Overriding QoS profile for topic %s", topic.name.c_str());
    }
    try {
      publishers_[topic.name] = create_generic_publisher(
        topic.name, topic.type, own ? chosen->second : offer_for(topic.name, parse_offers(topic.offered_qos_profiles)));
    } catch (const std::exception & error) {  // a type that is not known does not keep the others from being played
      RCLCPP_WARN(get_logger(), "Ignoring a topic '%s', reason: %s.", topic.name.c_str(), error.what());
    }
  }
}
void Player::publish_clock()
{
  if (play_options_.clock_publish_frequency <= 0) {
    return;
  }
  auto out = create_publisher<rosgraph_msgs::msg::Clock>("/clock", rclcpp::QoS(1));
  clock_timer_ = create_wall_timer(
    std::chrono::nanoseconds(std::llround(1e9 / play_options_.clock_publish_frequency)), [this, out] {
      rosgraph_msgs::msg::Clock message;
      message.clock = rclcpp::Time(position());
      out->publish(message);
    });
}

void Player::play()
{
  if (!reader_) {
    return;
  }
  do {
    if (play_options_.delay > rclcpp::Duration(0, 0)) {
      RCLCPP_INFO(get_logger(), "Sleep %ld ns", static_cast<long>(play_options_.delay.nanoseconds()));
      rclcpp::sleep_for(std::chrono::nanoseconds(play_options_.delay.nanoseconds()), get_node_base_interface()->get_context());
    }
    play_once();
  } while (play_options_.loop && goes_on());
  wait_for_listeners();
}
void Player::play_once()
{
  {
    std::lock_guard<std::recursive_mutex> hold(lock_);
    seek(start_);
  }
  while (goes_on()) {
    int64_t wait = 0;
    Message message = take(false, wait);
    if (message) {
      publish(message);
    } else if (wait > 0) {
      rclcpp::sleep_for(std::chrono::nanoseconds(wait), get_node_base_interface()->get_context());
    } else {
      return;
    }
  }
}
bool Player::goes_on() const {return rclcpp::ok(const_cast<Player *>(this)->get_node_base_interface()->get_context());}
Player::Message Player::take(bool at_once, int64_t & wait)
{
  std::lock_guard<std::recursive_mutex> hold(lock_);
  wait = 0;
  if (!next_ && !reader_->has_next()) {
    return nullptr;
  }
  if (!next_) {
    next_ = reader_->read_next();
  }
  if (!at_once) {
    const double left = static_cast<double>(next_->time_stamp - position()) / rate_;
    wait = paused_ || left > LONGEST_WAIT_NS ? LONGEST_WAIT_NS : static_cast<int64_t>(std::ceil(left));
    if (wait > 0) {
      return nullptr;
    }
  }
  return std::exchange(next_, nullptr);
}
bool Player::publish(const Message & message)
{
  auto out = publishers_.find(message->topic_name);
  if (out == publishers_.end()) {
    return false;
  }
  Callbacks before, after;
  {
    std::lock_guard<std::mutex> hold(callbacks_lock_);
    before = before_;
    after = after_;
  }
  for (auto & entry : before) {
    entry.second(message);
  }
  out->second->publish(rclcpp::SerializedMessage(*message->serialized_data));
  for (auto & entry : after) {
    entry.second(message);
  }
  return true;
}
void Player::wait_for_listeners()
{
  if (play_options_.wait_acked_timeout < 0) {
    return;
  }
  const std::chrono::milliseconds timeout(play_options_.wait_acked_timeout ? play_options_.wait_acked_timeout : -1);
  for (auto & entry : publishers_) {
    if (!entry.second->wait_for_all_acked(timeout)) {
      RCLCPP_ERROR(
        get_logger(), "Timed out while waiting for all published messages to be acknowledged for topic %s", entry.first.c_str());
    }
  }
}

Player::callback_handle_t Player::add(Callbacks & callbacks, const play_msg_callback_t & callback)
{
  if (!callback) {
    return invalid_callback_handle;
  }
  std::lock_guard<std::mutex> hold(callbacks_lock_);
  callbacks[++last_handle_] = callback;
  return last_handle_;
}
Player::callback_handle_t Player::add_on_play_message_pre_callback(const play_msg_callback_t & callback)
{
  return add(before_, callback);
}
Player::callback_handle_t Player::add_on_play_message_post_callback(const play_msg_callback_t & callback)
{
  return add(after_, callback);
}
void Player::delete_on_play_message_callback(const callback_handle_t & handle)
{
  std::lock_guard<std::mutex> hold(callbacks_lock_);
  before_.erase(handle);
  after_.erase(handle);
}
}  // namespace rosbag2_transport
