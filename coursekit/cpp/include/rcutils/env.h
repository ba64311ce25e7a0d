// Environment variables, in C: what is asked for is null, or says why it failed.
#pragma once
#include <cstdlib>

#include "rcutils/error_handling.h"

inline const char * rcutils_get_env(const char * name, const char ** value)
{
  if (!name || !value) {
    return name ? "argument env_value is null" : "argument env_name is null";
  }
  const char * found = std::getenv(name);
  *value = found ? found : "";
  return nullptr;
}
/// The user's home; null where the environment does not say.
inline const char * rcutils_get_home_dir()
{
#ifdef _WIN32
  return std::getenv("USERPROFILE");
#else
  return std::getenv("HOME");
#endif
}
/// Set a variable, or remove it where the value is null.
inline bool rcutils_set_env(const char * name, const char * value)
{
  RCUTILS_CHECK_ARGUMENT_FOR_NULL(name, false);
#ifdef _WIN32
  bool done = _putenv_s(name, value ? value : "") == 0;
#else
  bool done = value ? setenv(name, value, 1) == 0 : unsetenv(name) == 0;
#endif
  if (!done) {
    RCUTILS_SET_ERROR_MSG_WITH_FORMAT_STRING("failed to set environment variable %s", name);
  }
  return done;
}
