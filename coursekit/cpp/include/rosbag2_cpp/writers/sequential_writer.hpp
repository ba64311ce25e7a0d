// Writes a bag.
#pragma once
#include "rosbag2_cpp/coursekit_bag.hpp"
#include "rosbag2_cpp/writer_interfaces/base_writer_interface.hpp"

namespace rosbag2_cpp
{
namespace writers
{
class SequentialWriter : public writer_interfaces::BaseWriterInterface, public CoursekitBag
{
public:
  SequentialWriter()
  : SequentialWriter("", "NONE") {}
  ~SequentialWriter() override {let_go();}
  void open(const rosbag2_storage::StorageOptions & storage, const ConverterOptions & converter = {}) override
  {
    open_bag(storage, converter);
  }
  void close() override {close_bag();}
  void create_topic(const rosbag2_storage::TopicMetadata & topic) override {tell("bag_create_topic", topic);}
  void remove_topic(const rosbag2_storage::TopicMetadata & topic) override {tell("bag_remove_topic", topic);}
  bool take_snapshot() override {return ask("bag_snapshot", bag()).i();}
  void write(std::shared_ptr<rosbag2_storage::SerializedBagMessage> message) override
  {
    const auto & data = *message->serialized_data;
    std::string bytes(reinterpret_cast<const char *>(data.buffer), data.buffer_length);
    ask("bag_write", bag().s(message->topic_name).s(bytes).i(message->time_stamp));
  }

protected:
  SequentialWriter(const std::string & compression_format, const std::string & compression_mode)
  : CoursekitBag("bag_writer", coursekit::Packer{}.s(compression_format).s(compression_mode)) {}

private:
  void tell(const char * what, const rosbag2_storage::TopicMetadata & topic)
  {
    ask(what, bag().s(topic.name).s(topic.type).s(topic.serialization_format).s(topic.offered_qos_profiles));
  }
};
}  // namespace writers
}  // namespace rosbag2_cpp
