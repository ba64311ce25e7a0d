// Where and how a bag is stored: sizes are bytes, durations seconds, 0 is no limit.
#pragma once
#include <cstdint>
#include <string>

namespace rosbag2_storage
{
struct StorageOptions
{
  std::string uri;
  std::string storage_id;
  uint64_t max_bagfile_size = 0;
  uint64_t max_bagfile_duration = 0;
  uint64_t max_cache_size = 0;
  std::string storage_preset_profile;
  std::string storage_config_uri;
  bool snapshot_mode = false;
};
}  // namespace rosbag2_storage
