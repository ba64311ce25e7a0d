// A part of a text for another, wherever it is.
#pragma once
#include <string>

namespace rcpputils
{
template<class Char>
std::basic_string<Char> find_and_replace(
  const std::basic_string<Char> & text, const std::basic_string<Char> & find, const std::basic_string<Char> & replace)
{
  std::basic_string<Char> made = text;
  for (size_t at = 0; (at = made.find(find, at)) != made.npos && !find.empty(); at += replace.size()) {
    made.replace(at, find.size(), replace);
  }
  return made;
}
template<class Text, class Find, class Replace>
std::string find_and_replace(const Text & text, const Find & find, const Replace & replace)
{
  return find_and_replace<char>(std::string(text), std::string(find), std::string(replace));
}
}  // namespace rcpputils
