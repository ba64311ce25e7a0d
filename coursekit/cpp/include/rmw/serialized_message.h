// A message's bytes, in C.
#pragma once
#include "rcutils/types.h"

typedef rcutils_uint8_array_t rcl_serialized_message_t;
typedef rcutils_uint8_array_t rmw_serialized_message_t;

inline rmw_serialized_message_t rmw_get_zero_initialized_serialized_message()
{
  return rcutils_get_zero_initialized_uint8_array();
}
inline rmw_ret_t rmw_serialized_message_init(
  rmw_serialized_message_t * message, size_t capacity, const rcutils_allocator_t * allocator)
{
  return rcutils_uint8_array_init(message, capacity, allocator);
}
inline rmw_ret_t rmw_serialized_message_resize(rmw_serialized_message_t * message, size_t capacity)
{
  return rcutils_uint8_array_resize(message, capacity);
}
inline rmw_ret_t rmw_serialized_message_fini(rmw_serialized_message_t * message) {return rcutils_uint8_array_fini(message);}
