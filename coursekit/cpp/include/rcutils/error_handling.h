// The last error of a call in C, of each thread. Most that coursekit has do not fail here: they throw, or say so by what they return.
#pragma once
#include <stdint.h>
#include <stdio.h>

#include "rcutils/allocator.h"
#include "rcutils/macros.h"
#include "rcutils/types/rcutils_ret.h"

#define RCUTILS_ERROR_MESSAGE_MAX_LENGTH 1024
#define RCUTILS_ERROR_STATE_MESSAGE_MAX_LENGTH 768
#define RCUTILS_ERROR_STATE_FILE_MAX_LENGTH 229
typedef struct {char str[RCUTILS_ERROR_MESSAGE_MAX_LENGTH];} rcutils_error_string_t;
typedef rcutils_error_string_t rcl_error_string_t;
typedef struct
{
  char message[RCUTILS_ERROR_STATE_MESSAGE_MAX_LENGTH];
  char file[RCUTILS_ERROR_STATE_FILE_MAX_LENGTH];
  uint64_t line_number;
} rcutils_error_state_t;
typedef rcutils_error_state_t rcl_error_state_t;
struct coursekit_error_t
{
  bool is_set = false;
  rcutils_error_state_t state = {};
};
inline coursekit_error_t & coursekit_error()
{
  static thread_local coursekit_error_t last;
  return last;
}
/// Each thread's place for its error is there from the beginning.
inline rcutils_ret_t rcutils_initialize_error_handling_thread_local_storage(rcutils_allocator_t allocator)
{
  return rcutils_allocator_is_valid(&allocator) ? RCUTILS_RET_OK : RCUTILS_RET_INVALID_ARGUMENT;
}
inline void rcutils_set_error_state(const char * message, const char * file, size_t line)
{
  if (!message || !file) {
    return;
  }
  auto & error = coursekit_error();
  error.is_set = true;
  snprintf(error.state.message, sizeof(error.state.message), "%s", message);
  snprintf(error.state.file, sizeof(error.state.file), "%s", file);
  error.state.line_number = line;
}
inline const rcutils_error_state_t * rcutils_get_error_state()
{
  return coursekit_error().is_set ? &coursekit_error().state : nullptr;
}
inline bool rcutils_error_is_set() {return coursekit_error().is_set;}
inline void rcutils_reset_error() {coursekit_error() = {};}
/// The error with the place where it was set.
inline rcutils_error_string_t rcutils_get_error_string()
{
  if (!rcutils_error_is_set()) {
    return {"error not set"};
  }
  rcutils_error_string_t text;
  auto & state = coursekit_error().state;
  snprintf(text.str, sizeof(text.str), "%s, at %s:%llu", state.message, state.file, static_cast<unsigned long long>(state.line_number));
  return text;
}
#define RCUTILS_SET_ERROR_MSG(message) rcutils_set_error_state(message, __FILE__, __LINE__)
#define RCUTILS_SET_ERROR_MSG_WITH_FORMAT_STRING(...) \
  do { \
    char coursekit_message[RCUTILS_ERROR_MESSAGE_MAX_LENGTH]; \
    snprintf(coursekit_message, sizeof(coursekit_message), __VA_ARGS__); \
    RCUTILS_SET_ERROR_MSG(coursekit_message); \
  } while (0)
#define RCUTILS_CHECK_FOR_NULL_WITH_MSG(value, message, otherwise) \
  do { \
    if (nullptr == value) { \
      RCUTILS_SET_ERROR_MSG(message); \
      otherwise; \
    } \
  } while (0)
#define RCUTILS_CHECK_ARGUMENT_FOR_NULL(argument, returned) \
  RCUTILS_CHECK_FOR_NULL_WITH_MSG(argument, #argument " argument is null", return returned)
#define RCUTILS_SAFE_FWRITE_TO_STDERR(message) do {fputs(message, stderr);} while (0)
#define RCUTILS_SAFE_FWRITE_TO_STDERR_WITH_FORMAT_STRING(...) do {fprintf(stderr, __VA_ARGS__);} while (0)
#define RCL_SET_ERROR_MSG(message) RCUTILS_SET_ERROR_MSG(message)
#define RCL_SET_ERROR_MSG_WITH_FORMAT_STRING(...) RCUTILS_SET_ERROR_MSG_WITH_FORMAT_STRING(__VA_ARGS__)
#define RCL_CHECK_ARGUMENT_FOR_NULL(argument, returned) RCUTILS_CHECK_ARGUMENT_FOR_NULL(argument, returned)
#define RCL_CHECK_FOR_NULL_WITH_MSG(value, message, otherwise) RCUTILS_CHECK_FOR_NULL_WITH_MSG(value, message, otherwise)
#define RCL_CHECK_ALLOCATOR(allocator, otherwise) RCUTILS_CHECK_ALLOCATOR(allocator, otherwise)
#define RCL_CHECK_ALLOCATOR_WITH_MSG(allocator, message, otherwise) \
  RCUTILS_CHECK_ALLOCATOR_WITH_MSG(allocator, message, otherwise)
#define rcl_get_error_string rcutils_get_error_string
#define rcl_get_error_state rcutils_get_error_state
#define rcl_error_is_set rcutils_error_is_set
#define rcl_reset_error rcutils_reset_error
