// The last error of a call in C. Those that coursekit has do not fail here: they throw, or say so by what they return.
#pragma once
typedef struct {char str[1024];} rcutils_error_string_t;
typedef rcutils_error_string_t rcl_error_string_t;
inline rcutils_error_string_t rcutils_get_error_string() {return {"error not set"};}
inline bool rcutils_error_is_set() {return false;}
inline void rcutils_reset_error() {}
#define rcl_get_error_string rcutils_get_error_string
#define rcl_error_is_set rcutils_error_is_set
#define rcl_reset_error rcutils_reset_error
