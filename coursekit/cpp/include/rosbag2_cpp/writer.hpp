// Writes bags: serialized messages, or messages as they are.
#pragma once
#include "rosbag2_cpp/writers/sequential_writer.hpp"

namespace rosbag2_cpp
{
class Writer
{
public:
  explicit Writer(std::unique_ptr<writer_interfaces::BaseWriterInterface> writer = std::make_unique<writers::SequentialWriter>())
  : writer_(std::move(writer)) {}
  void open(const std::string & uri)
  {
    rosbag2_storage::StorageOptions storage;
    storage.uri = uri;
    storage.storage_id = "sqlite3";
    open(storage);
  }
  void open(const rosbag2_storage::StorageOptions & storage, const ConverterOptions & converter = {})
  {
    writer_->open(storage, converter);
  }
  void close() {writer_->close();}
  void create_topic(const rosbag2_storage::TopicMetadata & topic) {writer_->create_topic(topic);}
  void remove_topic(const rosbag2_storage::TopicMetadata & topic) {writer_->remove_topic(topic);}
  bool take_snapshot() {return writer_->take_snapshot();}

  void write(std::shared_ptr<rosbag2_storage::SerializedBagMessage> message) {writer_->write(message);}
  /// Enters the topic where it is new.
  void write(
    std::shared_ptr<rosbag2_storage::SerializedBagMessage> message, const std::string & topic, const std::string & type,
    const std::string & format = "cdr")
  {
    create_topic({topic, type, format, ""});
    write(message);
  }
  void write(
    std::shared_ptr<const rclcpp::SerializedMessage> message, const std::string & topic, const std::string & type,
    const rclcpp::Time & time)
  {
    write(*message, topic, type, time);
  }
  void write(
    const rclcpp::SerializedMessage & message, const std::string & topic, const std::string & type, const rclcpp::Time & time)
  {
    rcutils_uint8_array_t data = message.get_rcl_serialized_message();
    auto entry = std::make_shared<rosbag2_storage::SerializedBagMessage>();
    entry->serialized_data = std::make_shared<rcutils_uint8_array_t>(data);
    entry->time_stamp = time.nanoseconds();
    entry->topic_name = topic;
    write(entry, topic, type, rmw_get_serialization_format());
  }
  template<class M>
  void write(const M & message, const std::string & topic, const rclcpp::Time & time)
  {
    write(rclcpp::SerializedMessage(coursekit::to_cdr(message)), topic, M::coursekit_type, time);
  }
  writer_interfaces::BaseWriterInterface & get_implementation_handle() const {return *writer_;}

private:
  std::unique_ptr<writer_interfaces::BaseWriterInterface> writer_;
};
}  // namespace rosbag2_cpp
