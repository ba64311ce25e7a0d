// What every writer of bags does.
#pragma once
#include "rosbag2_cpp/converter_options.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/storage_options.hpp"
#include "rosbag2_storage/topic_metadata.hpp"

namespace rosbag2_cpp::writer_interfaces
{
class BaseWriterInterface
{
public:
  virtual ~BaseWriterInterface() = default;
  virtual void open(const rosbag2_storage::StorageOptions & storage_options, const ConverterOptions & converter_options) = 0;
  virtual void close() = 0;
  virtual void create_topic(const rosbag2_storage::TopicMetadata & topic_with_type) = 0;
  virtual void remove_topic(const rosbag2_storage::TopicMetadata & topic_with_type) = 0;
  virtual bool take_snapshot() = 0;
  virtual void write(std::shared_ptr<rosbag2_storage::SerializedBagMessage> message) = 0;
};
}  // namespace rosbag2_cpp::writer_interfaces
