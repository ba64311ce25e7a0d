// Which topics of a bag are read; all where there is no name.
#pragma once
#include <string>
#include <vector>

namespace rosbag2_storage
{
struct StorageFilter
{
  std::vector<std::string> topics;
  std::string topics_regex;
  std::string topics_regex_to_exclude;
};
}  // namespace rosbag2_storage
