// The type support of a message, or of what stands for one.
#pragma once
#include "rclcpp/type_adapter.hpp"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

namespace rclcpp
{
template<class T>
const rosidl_message_type_support_t & get_message_type_support_handle()
{
  return *rosidl_typesupport_cpp::get_message_type_support_handle<MessageOf<T>>();
}
}  // namespace rclcpp
