// What a bag says of itself, without reading its messages.
#pragma once
#include <string>

#include "rosbag2_cpp/readers/sequential_reader.hpp"

namespace rosbag2_cpp
{
class Info
{
public:
  virtual ~Info() = default;
  /// The metadata of a bag; std::runtime_error where there is none.
  virtual rosbag2_storage::BagMetadata read_metadata(const std::string & uri, const std::string & storage_id = "")
  {
    rosbag2_storage::StorageOptions storage;
    storage.uri = uri;
    storage.storage_id = storage_id;
    readers::SequentialReader reader;
    reader.open(storage);
    return reader.get_metadata();
  }
};
}  // namespace rosbag2_cpp
