// What a player plays, and how.
#pragma once
#include <string>
#include <unordered_map>
#include <vector>

#include "rclcpp/duration.hpp"
#include "rclcpp/qos.hpp"
#include "rcutils/time.h"

namespace rosbag2_transport
{
struct PlayOptions
{
  size_t read_ahead_queue_size = 1000;
  std::string node_prefix;
  float rate = 1.0f;
  /// All topics where there is no name.
  std::vector<std::string> topics_to_filter;
  std::string topics_regex_to_filter, topics_regex_to_exclude;
  std::unordered_map<std::string, rclcpp::QoS> topic_qos_profile_overrides{};
  bool loop = false;
  std::vector<std::string> topic_remapping_options;
  /// How often /clock is published, per second; 0 for never.
  double clock_publish_frequency = 0.0;
  rclcpp::Duration delay{0, 0};
  rcutils_duration_value_t start_offset = 0;
  bool start_paused = false;
  bool disable_keyboard_controls = false;
  /// How long to wait at the end for all that was published to arrive, milliseconds; 0 for ever, below it not at all.
  int64_t wait_acked_timeout = -1;
};
}  // namespace rosbag2_transport
