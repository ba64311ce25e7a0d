#include <cstring>

#include "check.hpp"
#include "nav_msgs/msg/odometry.hpp"
#include "rcpputils/asserts.hpp"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;
struct Word {std::string text; bool operator==(const Word & other) const {return text == other.text;}};

template<>
struct rclcpp::TypeAdapter<Word, String>
{
  using is_specialized = std::true_type;
  using custom_type = Word;
  using ros_message_type = String;
  static void convert_to_ros_message(const Word & from, String & to) {to.data = from.text + "!";}
  static void convert_to_custom(const String & from, Word & to) {to.text = from.data;}
};
RCLCPP_USING_CUSTOM_TYPE_AS_ROS_MESSAGE_TYPE(Word, String);

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::Serialization<String> serialization;
  String said, read;
  said.data = "hello";
  rclcpp::SerializedMessage bytes;
  serialization.serialize_message(&said, &bytes);
  equal("size", bytes.size(), 4u + 4u + 6u);
  const uint8_t start[] = {0, 1, 0, 0, 6, 0, 0, 0, 'h'};
  check("CDR, little endian", !std::memcmp(bytes.get_rcl_serialized_message().buffer, start, sizeof(start)));
  serialization.deserialize_message(&bytes, &read);
  equal("there and back", read.data, "hello");
  nav_msgs::msg::Odometry odometry, again;
  odometry.header.frame_id = "odom";
  odometry.pose.covariance[35] = 0.5;
  rclcpp::SerializedMessage larger;
  rclcpp::Serialization<nav_msgs::msg::Odometry>().serialize_message(&odometry, &larger);
  rclcpp::Serialization<nav_msgs::msg::Odometry>().deserialize_message(&larger, &again);
  check("a nested message", again == odometry);
  rclcpp::SerializedMessage copy(bytes);
  check("a copy has bytes of its own",
    copy.size() == bytes.size() && copy.get_rcl_serialized_message().buffer != bytes.get_rcl_serialized_message().buffer);
  rclcpp::SerializedMessage reserved;
  reserved.reserve(100);
  check("room is reserved", reserved.capacity() >= 100 && reserved.size() == 0);
  rclcpp::SerializedMessage of_c(bytes.get_rcl_serialized_message());
  equal("from C's bytes", of_c.size(), bytes.size());
  auto given = of_c.release_rcl_serialized_message();
  check("bytes are handed over", given.buffer_length == bytes.size() && of_c.size() == 0);
  std::free(given.buffer);
  check("cut off bytes are refused", [&] {
      rclcpp::SerializedMessage cut(bytes);
      cut.get_rcl_serialized_message().buffer_length = 9;
      try {
        serialization.deserialize_message(&cut, &read);
      } catch (const std::exception &) {
        return true;
      }
      return false;
    }());

  // adapted types
  // bytes change hands
  rclcpp::SerializedMessage hello(13);
  memcpy(hello.get_rcl_serialized_message().buffer, "Hello World", 12);
  hello.get_rcl_serialized_message().buffer_length = 12;
  rclcpp::SerializedMessage twin(hello);
  check("a copy has as much room", twin.capacity() == 13 && twin.size() == 12);
  rclcpp::SerializedMessage moved(std::move(hello));
  check("what is moved away is empty", hello.size() == 0 && hello.capacity() == 0 && !hello.get_rcl_serialized_message().buffer);
  check("and is elsewhere", moved.capacity() == 13 && std::string(moved.bytes().data()) == "Hello World");
  rcl_serialized_message_t handed = moved.release_rcl_serialized_message();
  check("released with its room", handed.buffer_capacity == 13 && handed.buffer_length == 12 && moved.capacity() == 0);
  twin = handed;
  moved = std::move(handed);
  check("C's are copied and moved", twin.capacity() == 13 && moved.size() == 12 && !handed.buffer);
  twin = std::move(moved);
  check("by assignment", twin.size() == 12 && moved.capacity() == 0);
  throws<std::length_error>("no room", [] {rclcpp::SerializedMessage(static_cast<size_t>(-1));});
  rclcpp::Serialization<String> strings;
  String filled;
  throws<rcpputils::IllegalStateException>("bytes of nothing", [&] {strings.deserialize_message(&moved, &filled);});
  throws<rcpputils::IllegalStateException>("bytes to nowhere", [&] {strings.serialize_message(&filled, nullptr);});

  auto node = rclcpp::Node::make_shared("adapted");
  using Adapted = rclcpp::TypeAdapter<Word, String>;
  check("an adapter in words", std::is_same_v<rclcpp::adapt_type<Word>::as<String>, Adapted>);
  std::vector<std::string> heard;
  auto plain = node->create_subscription<String>("word", 10, [&](const String & m) {heard.push_back("plain " + m.data);});
  auto custom = node->create_subscription<Adapted>("word", 10, [&](const Word & m) {heard.push_back("custom " + m.text);});
  auto pointer = node->create_subscription<Word>("word", 10, [&](std::shared_ptr<const Word> m) {heard.push_back("short " + m->text);});
  auto publisher = node->create_publisher<Adapted>("word", 10);
  publisher->publish(Word{"a"});
  spin_until(node, [&] {return heard.size() == 3;});
  std::sort(heard.begin(), heard.end());
  check("a custom type goes as its message", heard == std::vector<std::string>({"custom a!", "plain a!", "short a!"}));
  heard.clear();
  publisher->publish(std::make_unique<Word>(Word{"b"}));
  publisher->publish(said);
  spin_until(node, [&] {return heard.size() == 6;});
  equal("by pointer, and as the message itself", std::count(heard.begin(), heard.end(), "custom hello"), 1);
  auto by_word = node->create_publisher<Word>("word", 10);
  heard.clear();
  by_word->publish(Word{"c"});
  spin_until(node, [&] {return heard.size() == 3;});
  equal("named by the custom type alone", std::count(heard.begin(), heard.end(), "plain c!"), 1);

  // messages themselves
  check("equal", String() == String());
  check("chained setters", String().set__data("x").data == "x");
  check("defaults are zero", nav_msgs::msg::Odometry().pose.covariance[3] == 0.0);
  equal("type's name", std::string(rosidl_generator_traits::name<String>()), "std_msgs/msg/String");
  rclcpp::shutdown();
}
