// The node that plays a bag.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rclcpp/rclcpp.hpp"
#include "rosbag2_cpp/reader.hpp"
#include "rosbag2_storage/storage_options.hpp"
#include "rosbag2_transport/play_options.hpp"

namespace rosbag2_transport
{
/// Publishes the messages of a bag when play() is called. An executor that spins it answers its services meanwhile.
class Player : public rclcpp::Node
{
public:
  using play_msg_callback_t = std::function<void (std::shared_ptr<rosbag2_storage::SerializedBagMessage>)>;
  using callback_handle_t = uint64_t;
  static constexpr callback_handle_t invalid_callback_handle = 0;

  explicit Player(
    const std::string & node_name = "rosbag2_player", const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions());
  Player(
    const rosbag2_storage::StorageOptions & storage_options, const PlayOptions & play_options,
    const std::string & node_name = "rosbag2_player", const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions());
  Player(
    std::unique_ptr<rosbag2_cpp::Reader> reader, const rosbag2_storage::StorageOptions & storage_options,
    const PlayOptions & play_options, const std::string & node_name = "rosbag2_player",
    const rclcpp::NodeOptions & node_options = rclcpp::NodeOptions());
  ~Player() override;

  /// Play to the end, or until the context ends; with the option `loop` only until that.
  void play();
  void pause();
  void resume();
  void toggle_paused();
  bool is_paused() const;
  double get_rate() const;
  /// Play at another rate from now on; false for one that is not above 0.
  virtual bool set_rate(double rate);
  /// While paused: publish the next message; whether there was one.
  virtual bool play_next();
  /// While paused: publish so many messages at once, 0 for all that are left; how many there were.
  virtual size_t burst(const size_t num_messages);
  /// Go on from a time in the recording, not before its start.
  void seek(rcutils_time_point_value_t time_point);
  /// Have a function called before each message is published, or after it.
  callback_handle_t add_on_play_message_pre_callback(const play_msg_callback_t & callback);
  callback_handle_t add_on_play_message_post_callback(const play_msg_callback_t & callback);
  void delete_on_play_message_callback(const callback_handle_t & handle);

protected:
  std::map<std::string, rclcpp::GenericPublisher::SharedPtr> publishers_;

private:
  using Message = std::shared_ptr<rosbag2_storage::SerializedBagMessage>;
  using Callbacks = std::map<callback_handle_t, play_msg_callback_t>;
  void make_publishers();
  void make_services();
  void publish_clock();
  void play_once();
  void wait_for_listeners();
  bool goes_on() const;
  /// The next message, if it is due or the player is paused and it is wanted anyway; else how long to wait for it.
  Message take(bool at_once, int64_t & wait);
  bool publish(const Message & message);
  bool skip_to_next();
  int64_t position() const;
  void jump(int64_t position);
  callback_handle_t add(Callbacks & callbacks, const play_msg_callback_t & callback);

  std::unique_ptr<rosbag2_cpp::Reader> reader_;
  rosbag2_storage::StorageOptions storage_options_;
  PlayOptions play_options_;
  mutable std::recursive_mutex lock_;
  Message next_;
  int64_t start_ = 0, here_ = 0, there_ = 0;  // the recording's first time; a time of the steady clock, and of the recording then
  double rate_ = 1.0;
  bool paused_ = false;
  std::mutex callbacks_lock_;
  Callbacks before_, after_;
  callback_handle_t last_handle_ = invalid_callback_handle;
  std::vector<rclcpp::ServiceBase::SharedPtr> services_;
  rclcpp::TimerBase::SharedPtr clock_timer_;
};
}  // namespace rosbag2_transport
