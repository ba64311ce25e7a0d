// Variables of the environment.
#pragma once
#include <stdexcept>
#include <string>

#include "rcutils/env.h"

namespace rcpputils
{
/// The value of a variable; empty where it is not set, std::runtime_error without a name.
inline std::string get_env_var(const char * name)
{
  const char * value = nullptr;
  const char * why_not = rcutils_get_env(name, &value);
  if (why_not) {
    throw std::runtime_error(why_not);
  }
  return value;
}
/// Set a variable, or unset it where the value is null; std::runtime_error where that fails.
inline bool set_env_var(const char * name, const char * value)
{
  if (!rcutils_set_env(name, value)) {
    const std::string why_not = rcutils_get_error_string().str;
    rcutils_reset_error();
    throw std::runtime_error(why_not);
  }
  return true;
}
}  // namespace rcpputils
