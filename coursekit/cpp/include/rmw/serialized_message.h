// A message's bytes, in C: the buffer is the program's own memory.
#pragma once
#include <stdint.h>
#include <stdlib.h>

#include "rcutils/logging.h"

typedef struct {uint8_t * buffer; size_t buffer_length; size_t buffer_capacity;} rcutils_uint8_array_t;
typedef rcutils_uint8_array_t rcl_serialized_message_t;
typedef rcutils_uint8_array_t rmw_serialized_message_t;

inline rmw_serialized_message_t rmw_get_zero_initialized_serialized_message() {return {nullptr, 0, 0};}
inline rmw_ret_t rmw_serialized_message_resize(rmw_serialized_message_t * message, size_t capacity)
{
  if (!message || !capacity) {
    return RCUTILS_RET_INVALID_ARGUMENT;
  }
  void * grown = realloc(message->buffer, capacity);
  if (!grown) {
    return RCUTILS_RET_ERROR;
  }
  message->buffer = static_cast<uint8_t *>(grown);
  message->buffer_capacity = capacity;
  message->buffer_length = message->buffer_length < capacity ? message->buffer_length : capacity;
  return RMW_RET_OK;
}
inline rmw_ret_t rmw_serialized_message_init(
  rmw_serialized_message_t * message, size_t capacity, const rcutils_allocator_t *)
{
  *message = rmw_get_zero_initialized_serialized_message();
  return capacity ? rmw_serialized_message_resize(message, capacity) : RMW_RET_OK;
}
inline rmw_ret_t rmw_serialized_message_fini(rmw_serialized_message_t * message)
{
  free(message->buffer);
  *message = rmw_get_zero_initialized_serialized_message();
  return RMW_RET_OK;
}
