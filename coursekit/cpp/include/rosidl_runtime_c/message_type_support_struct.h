// What stands for a type of messages: who supports it, and what is known of it.
#pragma once
#include <string.h>

struct rosidl_message_type_support_t;
typedef const rosidl_message_type_support_t * (* rosidl_message_typesupport_handle_function)(
  const rosidl_message_type_support_t * handle, const char * identifier);

/// The handle itself where it is of that support, otherwise null.
inline const rosidl_message_type_support_t * get_message_typesupport_handle_function(
  const rosidl_message_type_support_t * handle, const char * identifier);
struct rosidl_message_type_support_t
{
  const char * typesupport_identifier;
  const void * data;
  rosidl_message_typesupport_handle_function func = get_message_typesupport_handle_function;
};
inline const rosidl_message_type_support_t * get_message_typesupport_handle_function(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return strcmp(handle->typesupport_identifier, identifier) == 0 ? handle : nullptr;
}
/// The handle of another support of the same type; null where there is none.
inline const rosidl_message_type_support_t * get_message_typesupport_handle(
  const rosidl_message_type_support_t * handle, const char * identifier)
{
  return handle->func(handle, identifier);
}
