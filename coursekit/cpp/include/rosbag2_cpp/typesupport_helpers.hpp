// Type support by the name of a type, under the names of programs that write bags in the way of Foxy's tutorial.
#pragma once
#include <tuple>

#include "rclcpp/typesupport_helpers.hpp"

namespace rosbag2_cpp
{
using rclcpp::get_typesupport_library;
inline const rosidl_message_type_support_t * get_typesupport_handle(
  const std::string & type, const std::string & typesupport_identifier, std::shared_ptr<rcpputils::SharedLibrary> library)
{
  return rclcpp::get_typesupport_handle(type, typesupport_identifier, *library);
}
/// The package of a type, its kind if the name has one, and its own name.
inline const std::tuple<std::string, std::string, std::string> extract_type_identifier(const std::string & full_type)
{
  const auto first = full_type.find('/'), last = full_type.rfind('/');
  if (last == std::string::npos || last == 0 || last + 1 == full_type.size()) {
    throw std::runtime_error("Message type is not of the form package/type and cannot be processed");
  }
  const auto kind = first == last ? "" : full_type.substr(first + 1, last - first - 1);
  return {full_type.substr(0, first), kind, full_type.substr(last + 1)};
}
}  // namespace rosbag2_cpp
