// Variables of the environment.
#pragma once
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace rcpputils
{
/// The value of a variable; empty where it is not set, std::runtime_error without a name.
inline std::string get_env_var(const char * name)
{
  if (!name) {
    throw std::runtime_error("argument env_name is null");
  }
  const char * value = std::getenv(name);
  return value ? value : "";
}
/// Set a variable, or unset it where the value is null.
inline bool set_env_var(const char * name, const char * value)
{
  if (!name) {
    throw std::runtime_error("argument env_name is null");
  }
#ifdef _WIN32
  bool done = _putenv_s(name, value ? value : "") == 0;
#else
  bool done = value ? setenv(name, value, 1) == 0 : unsetenv(name) == 0;
#endif
  if (!done) {
    throw std::runtime_error(std::string("failed to set environment variable ") + name);
  }
  return true;
}
}  // namespace rcpputils
