// What programs ask of the middleware itself.
#pragma once
#include "rmw/serialized_message.h"
#include "rmw/types.h"
#include "rosidl_typesupport_cpp/message_type_support.hpp"

/// How messages travel here.
inline const char * rmw_get_serialization_format() {return "cdr";}
inline const char * rmw_get_implementation_identifier() {return "rmw_fastrtps_cpp";}
/// A message as bytes, in a buffer that grows where it is too small.
rmw_ret_t rmw_serialize(
  const void * message, const rosidl_message_type_support_t * type_support, rmw_serialized_message_t * serialized_message);
rmw_ret_t rmw_deserialize(
  const rmw_serialized_message_t * serialized_message, const rosidl_message_type_support_t * type_support, void * message);
