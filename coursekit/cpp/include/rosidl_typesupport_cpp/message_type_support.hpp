// What stands for a message's type where a program does not name it: its name, and how its messages become bytes.
#pragma once
#include <string>

#include "coursekit/cdr.hpp"
#include "rosidl_runtime_c/message_type_support_struct.h"

namespace coursekit
{
/// A type of messages; of one that the program knows by its name only, nothing but the name.
struct MessageType
{
  std::string name;
  std::string (* to_bytes)(const void * message) = nullptr;
  void (* from_bytes)(const std::string & bytes, void * message) = nullptr;
};
template<class M>
const MessageType & message_type()
{
  static const MessageType type{
    M::coursekit_type, [](const void * message) {return to_cdr(*static_cast<const M *>(message));},
    [](const std::string & bytes, void * message) {from_cdr(bytes, *static_cast<M *>(message));}};
  return type;
}
}  // namespace coursekit

namespace rosidl_typesupport_cpp
{
constexpr char typesupport_identifier[] = "rosidl_typesupport_cpp";
/// The handle of a message's type, whose data are its coursekit::MessageType.
template<class M>
const rosidl_message_type_support_t * get_message_type_support_handle()
{
  static const rosidl_message_type_support_t handle{typesupport_identifier, &coursekit::message_type<M>()};
  return &handle;
}
}  // namespace rosidl_typesupport_cpp
