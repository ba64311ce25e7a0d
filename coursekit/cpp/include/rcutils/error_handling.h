// The last error of a call in C, of each thread. Most that coursekit has do not fail here: they throw, or say so by what they return.
#pragma once
#include <stdint.h>
#include <stdio.h>

typedef struct {char str[1024];} rcutils_error_string_t;
typedef rcutils_error_string_t rcl_error_string_t;
typedef struct {char message[768]; char file[229]; uint64_t line_number;} rcutils_error_state_t;
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
inline void rcutils_set_error_state(const char * message, const char * file, size_t line)
{
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
#define RCL_SET_ERROR_MSG(message) RCUTILS_SET_ERROR_MSG(message)
#define rcl_get_error_string rcutils_get_error_string
#define rcl_get_error_state rcutils_get_error_state
#define rcl_error_is_set rcutils_error_is_set
#define rcl_reset_error rcutils_reset_error
