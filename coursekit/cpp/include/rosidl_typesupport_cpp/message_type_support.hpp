// What stands for a message's type where a program does not name it: the name of the type.
#pragma once

struct rosidl_message_type_support_t
{
  const char * typesupport_identifier;
  const void * data;
};

namespace rosidl_typesupport_cpp
{
/// The handle of a message's type; its data is the type's name, `std_msgs/msg/String`.
template<class M>
const rosidl_message_type_support_t * get_message_type_support_handle()
{
  static const rosidl_message_type_support_t handle{"coursekit", M::coursekit_type};
  return &handle;
}
}  // namespace rosidl_typesupport_cpp
