#pragma once
/// Whether a character is a digit or a letter of ASCII.
inline bool rcutils_isalnum_no_locale(char c)
{
  return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}
