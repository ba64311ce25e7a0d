// Types by their support: of a class, or of a name.
#include "check.hpp"
#include "rclcpp/get_message_type_support_handle.hpp"
#include "rclcpp/typesupport_helpers.hpp"
#include "rosbag2_cpp/typesupport_helpers.hpp"
#include "rcpputils/asserts.hpp"
#include "rmw/rmw.h"
#include "std_msgs/msg/string.hpp"

using std_msgs::msg::String;

int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto support = rosidl_typesupport_cpp::get_message_type_support_handle<String>();
  check("one for each class", support == &rclcpp::get_message_type_support_handle<String>());
  equal("who supports it", std::string(support->typesupport_identifier), "rosidl_typesupport_cpp");

  // in C
  String said, read;
  said.data = "hello";
  auto bytes = rmw_get_zero_initialized_serialized_message();
  auto allocator = rcutils_get_default_allocator();
  check("room for nothing", rmw_serialized_message_init(&bytes, 0, &allocator) == RMW_RET_OK);
  check("a message becomes bytes", rmw_serialize(&said, support, &bytes) == RMW_RET_OK);
  equal("for which the buffer grows", bytes.buffer_length, 14u);
  check("and back", rmw_deserialize(&bytes, support, &read) == RMW_RET_OK && read.data == "hello");
  bytes.buffer_length = 9;
  check("cut off bytes are no message", rmw_deserialize(&bytes, support, &read) == RMW_RET_ERROR);
  bytes.buffer_length = 14;
  check("nothing is no message", rmw_serialize(nullptr, support, &bytes) == RMW_RET_INVALID_ARGUMENT);

  // by a support
  rclcpp::SerializationBase by_support(support);
  rclcpp::SerializedMessage packed;
  by_support.serialize_message(&said, &packed);
  read.data.clear();
  by_support.deserialize_message(&packed, &read);
  equal("there and back", read.data, "hello");
  throws<rcpputils::IllegalStateException>("no support", [] {rclcpp::SerializationBase(nullptr);});
  throws<rcpputils::IllegalStateException>("no message", [&] {by_support.serialize_message(nullptr, &packed);});

  rclcpp::SerializedMessage grown;
  auto & within = grown.get_rcl_serialized_message();
  check("bytes of C++ grow in C", rmw_serialize(&said, support, &within) == RMW_RET_OK && grown.size() == 14u);
  check("and are read in C++", (by_support.deserialize_message(&grown, &read), read.data == "hello"));
  check("what grows keeps its bytes", rmw_serialized_message_resize(&within, 4096) == RMW_RET_OK && grown.bytes() == packed.bytes());

  // by a name
  const std::string plain = "rosidl_typesupport_cpp";
  auto library = rclcpp::get_typesupport_library("std_msgs/msg/String", plain);
  auto named = rclcpp::get_typesupport_handle("std_msgs/msg/String", plain, *library);
  check("a name has a support", named && named == rclcpp::get_typesupport_handle("std_msgs/msg/String", plain, *library));
  check("rosbag2's names for it", rosbag2_cpp::get_typesupport_handle("std_msgs/msg/String", plain,
    rosbag2_cpp::get_typesupport_library("std_msgs/msg/String", plain)) != nullptr);
  check("a type's parts", rosbag2_cpp::extract_type_identifier("std_msgs/msg/String") ==
    std::make_tuple(std::string("std_msgs"), std::string("msg"), std::string("String")));
  equal("a type without its kind", std::get<1>(rosbag2_cpp::extract_type_identifier("std_msgs/String")), "");
  throws<std::runtime_error>("a type of no package", [] {rosbag2_cpp::extract_type_identifier("String");});
  throws<std::runtime_error>("not a name of none", [&] {rclcpp::get_typesupport_library("std_msgs/msg/Nothing", plain);});
  throws<std::runtime_error>(
    "no library looks into messages",
    [] {rclcpp::get_typesupport_library("std_msgs/msg/String", "rosidl_typesupport_introspection_cpp");});
  throws<std::runtime_error>("nor does a name", [&] {rclcpp::SerializationBase(named).deserialize_message(&packed, &read);});
  check("also in C", rmw_deserialize(&bytes, named, &read) == RMW_RET_ERROR);
  check("free", rmw_serialized_message_fini(&bytes) == RMW_RET_OK);

  auto node = rclcpp::Node::make_shared("typed");
  auto typed = node->create_subscription<String>("words", 1, [](const String &) {});
  check("a subscription has that of its class", &typed->get_message_type_support_handle() == support);
  auto generic = node->create_generic_subscription(
    "words", "std_msgs/msg/String", 1, [](std::shared_ptr<rclcpp::SerializedMessage>) {});
  check("a generic one that of its name", &generic->get_message_type_support_handle() == named);
  rclcpp::shutdown();
}
