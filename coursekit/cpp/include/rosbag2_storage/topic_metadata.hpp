// A topic of a bag.
#pragma once
#include <string>

namespace rosbag2_storage
{
struct TopicMetadata
{
  std::string name;
  std::string type;
  std::string serialization_format;
  std::string offered_qos_profiles;
  bool operator==(const TopicMetadata & other) const
  {
    return name == other.name && type == other.type && serialization_format == other.serialization_format &&
           offered_qos_profiles == other.offered_qos_profiles;
  }
};
struct TopicInformation
{
  TopicMetadata topic_metadata;
  size_t message_count = 0;
};
}  // namespace rosbag2_storage
