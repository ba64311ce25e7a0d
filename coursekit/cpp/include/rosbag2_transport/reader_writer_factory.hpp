// Makes readers for bags, whatever they are stored in.
#pragma once
#include "rosbag2_cpp/reader.hpp"

namespace rosbag2_transport
{
class ReaderWriterFactory
{
public:
  /// A reader that is not open yet; upstream looks here whether the bag is compressed, which ours sees when it opens one.
  static std::unique_ptr<rosbag2_cpp::Reader> make_reader(const rosbag2_storage::StorageOptions &)
  {
    return std::make_unique<rosbag2_cpp::Reader>();
  }
};
}  // namespace rosbag2_transport
