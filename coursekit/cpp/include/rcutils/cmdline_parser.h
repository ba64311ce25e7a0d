// Options among a program's words.
#pragma once
#include <cstring>

inline char ** coursekit_cli_find(char ** begin, char ** end, const char * option)
{
  while (begin != end && std::strcmp(*begin, option) != 0) {
    ++begin;
  }
  return begin;
}
inline bool rcutils_cli_option_exist(char ** begin, char ** end, const char * option)
{
  return coursekit_cli_find(begin, end, option) != end;
}
/// The word behind an option; nullptr where there is none.
inline char * rcutils_cli_get_option(char ** begin, char ** end, const char * option)
{
  char ** found = coursekit_cli_find(begin, end, option);
  return found == end || found + 1 == end ? nullptr : found[1];
}
