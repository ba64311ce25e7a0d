// Texts put together.
#pragma once
#include <sstream>

namespace rcpputils
{
template<class Container, class Char>
std::basic_string<Char> join(const Container & parts, const Char * delimiter)
{
  std::basic_ostringstream<Char> text;
  bool first = true;
  for (auto & part : parts) {
    if (!first) {
      text << delimiter;
    }
    first = false;
    text << part;
  }
  return text.str();
}
template<class Container, class Char>
std::basic_string<Char> join(const Container & parts, const std::basic_string<Char> & delimiter)
{
  return join(parts, delimiter.c_str());
}
}  // namespace rcpputils
