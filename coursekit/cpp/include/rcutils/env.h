// Environment variables, in C: what is asked for is null, or says why it failed.
#pragma once
#include <cstdlib>

#include "rcpputils/env.hpp"

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
  try {
    return name && rcpputils::set_env_var(name, value);
  } catch (const std::exception &) {
    return false;
  }
}
