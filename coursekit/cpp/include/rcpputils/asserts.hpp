// Conditions that must hold.
#pragma once
#include <stdexcept>
#include <string>

namespace rcpputils
{
class AssertionException : public std::runtime_error {using std::runtime_error::runtime_error;};
class IllegalStateException : public std::runtime_error {using std::runtime_error::runtime_error;};
inline void require_true(bool condition, const std::string & text = "invalid argument passed")
{
  if (!condition) {
    throw std::invalid_argument(text);
  }
}
inline void check_true(bool condition, const std::string & text = "check reported invalid state")
{
  if (!condition) {
    throw IllegalStateException(text);
  }
}
inline void assert_true(bool condition, const std::string & text = "assertion failed")
{
#ifndef NDEBUG
  if (!condition) {
    throw AssertionException(text);
  }
#else
  (void)condition;
  (void)text;
#endif
}
}  // namespace rcpputils
