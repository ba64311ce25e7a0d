// Reads a bag, oldest message first.
#pragma once
#include "rosbag2_cpp/coursekit_bag.hpp"
#include "rosbag2_cpp/reader_interfaces/base_reader_interface.hpp"

namespace rosbag2_cpp
{
namespace readers
{
class SequentialReader : public reader_interfaces::BaseReaderInterface, public CoursekitBag
{
public:
  SequentialReader()
  : CoursekitBag("bag_reader") {}
  ~SequentialReader() override {let_go();}
  void open(const rosbag2_storage::StorageOptions & storage, const ConverterOptions & converter = {}) override
  {
    open_bag(storage, converter);
    topics_.clear();
    auto answer = ask("bag_facts", bag());
    metadata_ = {};
    metadata_.version = static_cast<int>(answer.i());
    metadata_.bag_size = static_cast<uint64_t>(answer.i());
    metadata_.storage_identifier = answer.s();
    metadata_.duration = std::chrono::nanoseconds(answer.i());
    metadata_.starting_time = at(answer.i());
    metadata_.message_count = static_cast<uint64_t>(answer.i());
    metadata_.compression_format = answer.s();
    metadata_.compression_mode = answer.s();
    for (int64_t left = answer.i(); left > 0; --left) {
      metadata_.relative_file_paths.push_back(answer.s());
    }
    for (int64_t left = answer.i(); left > 0; --left) {
      rosbag2_storage::FileInformation file;
      file.path = answer.s();
      file.starting_time = at(answer.i());
      file.duration = std::chrono::nanoseconds(answer.i());
      file.message_count = static_cast<size_t>(answer.i());
      metadata_.files.push_back(file);
    }
    for (int64_t left = answer.i(); left > 0; --left) {
      rosbag2_storage::TopicInformation topic;
      topic.topic_metadata.name = answer.s();
      topic.topic_metadata.type = answer.s();
      topic.topic_metadata.serialization_format = answer.s();
      topic.topic_metadata.offered_qos_profiles = answer.s();
      topic.message_count = static_cast<size_t>(answer.i());
      topics_.push_back(topic.topic_metadata);
      metadata_.topics_with_message_count.push_back(topic);
    }
  }
  void close() override {close_bag();}
  bool has_next() override {return ask("bag_has_next", bag()).i();}
  std::shared_ptr<rosbag2_storage::SerializedBagMessage> read_next() override
  {
    auto answer = ask("bag_read_next", bag());
    auto message = std::make_shared<rosbag2_storage::SerializedBagMessage>();
    message->topic_name = answer.s();
    auto bytes = std::make_shared<std::string>(answer.s());
    message->time_stamp = answer.i();
    rcutils_uint8_array_t view{reinterpret_cast<uint8_t *>(bytes->data()), bytes->size(), bytes->size()};
    message->serialized_data = std::shared_ptr<rcutils_uint8_array_t>(
      new rcutils_uint8_array_t(view), [bytes](rcutils_uint8_array_t * data) {delete data;});
    return message;
  }
  const rosbag2_storage::BagMetadata & get_metadata() const override {return metadata_;}
  std::vector<rosbag2_storage::TopicMetadata> get_all_topics_and_types() const override {return topics_;}
  void set_filter(const rosbag2_storage::StorageFilter & filter) override
  {
    auto with = bag().s(filter.topics_regex).s(filter.topics_regex_to_exclude).i(static_cast<int64_t>(filter.topics.size()));
    for (const auto & topic : filter.topics) {
      with.s(topic);
    }
    ask("bag_filter", with);
  }
  void reset_filter() override {set_filter({});}
  void seek(const rcutils_time_point_value_t & time) override {ask("bag_seek", bag().i(time));}

private:
  static std::chrono::time_point<std::chrono::high_resolution_clock> at(int64_t nanoseconds)
  {
    return std::chrono::time_point<std::chrono::high_resolution_clock>(std::chrono::nanoseconds(nanoseconds));
  }
  rosbag2_storage::BagMetadata metadata_;
  std::vector<rosbag2_storage::TopicMetadata> topics_;
};
}  // namespace readers
}  // namespace rosbag2_cpp
