// Texts and their parts.
#pragma once
#include <string>
#include <vector>

namespace nav2_util
{
using Tokens = std::vector<std::string>;
inline std::string strip_leading_slash(const std::string & in)
{
  return !in.empty() && in.front() == '/' ? in.substr(1) : in;
}
inline Tokens split(const std::string & tokenstring, char delimiter)
{
  Tokens parts;
  size_t begin = 0;
  for (size_t end; (end = tokenstring.find(delimiter, begin)) != std::string::npos; begin = end + 1) {
    parts.push_back(tokenstring.substr(begin, end - begin));
  }
  parts.push_back(tokenstring.substr(begin));
  return parts;
}
}  // namespace nav2_util
