// Type support by the name of a type, for programs that handle messages of any.
#pragma once
#include <memory>
#include <string>

#include "rcpputils/shared_library.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{
/// The library that a type's support is in: here the program itself, for every type that the session knows.
/// Throws std::runtime_error for other types, and for a support that looks into messages: no library has one.
std::shared_ptr<rcpputils::SharedLibrary> get_typesupport_library(
  const std::string & type, const std::string & typesupport_identifier);
namespace detail
{
const rosidl_message_type_support_t * type_support_called(const std::string & type);
}
/// The support of a type by its name. Its messages stay bytes, since the program does not know what they have.
const rosidl_message_type_support_t * get_typesupport_handle(
  const std::string & type, const std::string & typesupport_identifier, rcpputils::SharedLibrary & library);
}  // namespace rclcpp
