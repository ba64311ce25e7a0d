// Reads bags: serialized messages, or messages of a type.
#pragma once
#include "rosbag2_cpp/readers/sequential_reader.hpp"

namespace rosbag2_cpp
{
class Reader
{
public:
  explicit Reader(std::unique_ptr<reader_interfaces::BaseReaderInterface> reader = std::make_unique<readers::SequentialReader>())
  : reader_(std::move(reader)) {}
  void open(const std::string & uri)
  {
    rosbag2_storage::StorageOptions storage;
    storage.uri = uri;
    open(storage);
  }
  void open(const rosbag2_storage::StorageOptions & storage, const ConverterOptions & converter = {})
  {
    reader_->open(storage, converter);
  }
  void close() {reader_->close();}
  bool has_next() {return reader_->has_next();}
  std::shared_ptr<rosbag2_storage::SerializedBagMessage> read_next() {return reader_->read_next();}
  template<class M>
  M read_next()
  {
    M message;
    rclcpp::SerializedMessage serialized(*read_next()->serialized_data);
    coursekit::from_cdr(serialized.bytes(), message);
    return message;
  }
  const rosbag2_storage::BagMetadata & get_metadata() const {return reader_->get_metadata();}
  std::vector<rosbag2_storage::TopicMetadata> get_all_topics_and_types() const {return reader_->get_all_topics_and_types();}
  void set_filter(const rosbag2_storage::StorageFilter & filter) {reader_->set_filter(filter);}
  void reset_filter() {reader_->reset_filter();}
  void seek(const rcutils_time_point_value_t & time) {reader_->seek(time);}
  reader_interfaces::BaseReaderInterface & get_implementation_handle() const {return *reader_;}

private:
  std::unique_ptr<reader_interfaces::BaseReaderInterface> reader_;
};
}  // namespace rosbag2_cpp
