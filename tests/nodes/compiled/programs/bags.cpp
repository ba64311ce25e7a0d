// Writes a bag in each of the ways there are, and reads it again.
#include <iostream>

#include "rclcpp/rclcpp.hpp"
#include "rclcpp/serialization.hpp"
#include "rosbag2_cpp/reader.hpp"
#include "rosbag2_cpp/writer.hpp"
#include "rosbag2_transport/reader_writer_factory.hpp"
#include "std_msgs/msg/int32.hpp"
#include "std_msgs/msg/string.hpp"

template<class F>
void attempt(F function)
{
  try {
    function();
    std::cout << "nothing was thrown" << std::endl;
  } catch (const std::runtime_error & error) {
    std::cout << error.what() << std::endl;
  }
}

int main(int argc, char ** argv)
{
  std_msgs::msg::Int32 number;
  std_msgs::msg::String text;
  rclcpp::Serialization<std_msgs::msg::String> serialization;
  {
    rosbag2_cpp::Writer writer;
    writer.open("bag");
    writer.create_topic({"number", "std_msgs/msg/Int32", rmw_get_serialization_format(), ""});
    rclcpp::Time time(10, 0);
    for (number.data = 0; number.data < 3; ++number.data, time += rclcpp::Duration(1, 0)) {
      writer.write(number, "number", time);
    }
    text.data = "shared";
    auto shared = std::make_shared<rclcpp::SerializedMessage>();
    serialization.serialize_message(&text, shared.get());
    writer.write(shared, "text", "std_msgs/msg/String", time);
    text.data = "by reference";
    serialization.serialize_message(&text, shared.get());
    writer.write(*shared, "text", "std_msgs/msg/String", time + rclcpp::Duration(1, 0));
    auto entry = std::make_shared<rosbag2_storage::SerializedBagMessage>();
    entry->topic_name = "text";
    entry->time_stamp = 20;
    entry->serialized_data = std::make_shared<rcutils_uint8_array_t>(shared->get_rcl_serialized_message());
    writer.write(entry);
    entry->topic_name = "unknown";
    attempt([&] {writer.write(entry);});
  }
  attempt([] {rosbag2_cpp::Writer().open("bag");});
  attempt([] {rosbag2_cpp::Reader().open("nowhere");});
  attempt([] {rosbag2_cpp::Reader().has_next();});

  rosbag2_cpp::Reader reader(std::make_unique<rosbag2_cpp::readers::SequentialReader>());
  reader.open({"bag", "sqlite3"}, {"cdr", "cdr"});
  auto & metadata = reader.get_metadata();
  std::cout << metadata.message_count << metadata.storage_identifier << metadata.relative_file_paths.at(0) << " "
            << metadata.duration.count() << " " << metadata.starting_time.time_since_epoch().count() << " "
            << metadata.files.at(0).message_count << metadata.topics_with_message_count.at(0).message_count << std::endl;
  for (auto & topic : reader.get_all_topics_and_types()) {
    std::cout << topic.name << " " << topic.type << " " << topic.serialization_format << std::endl;
  }
  while (reader.has_next()) {
    auto message = reader.read_next();
    std::cout << message->time_stamp << " " << message->topic_name;
    if (message->topic_name == "text") {
      rclcpp::SerializedMessage serialized(*message->serialized_data);
      serialization.deserialize_message(&serialized, &text);
      std::cout << " " << text.data;
    }
    std::cout << std::endl;
  }
  attempt([&] {reader.read_next();});
  rosbag2_storage::StorageFilter filter;
  filter.topics = {"number"};
  reader.set_filter(filter);
  reader.seek(11000000000);
  std::cout << reader.read_next<std_msgs::msg::Int32>().data << reader.read_next<std_msgs::msg::Int32>().data
            << reader.has_next() << std::endl;
  reader.close();
  rosbag2_storage::StorageOptions options;
  options.uri = "bag";
  std::unique_ptr<rosbag2_cpp::Reader> made = rosbag2_transport::ReaderWriterFactory::make_reader(options);
  made->open(options);
  std::cout << made->read_next()->topic_name << std::endl;

  rclcpp::init(argc, argv);  // a bag needs none
  rclcpp::shutdown();
}
