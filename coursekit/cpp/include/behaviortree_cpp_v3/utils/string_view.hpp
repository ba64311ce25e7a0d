// Texts by reference, under the name that programs for C++11 know them by.
#pragma once
#include <string>
#include <string_view>

namespace nonstd
{
using std::string_view;

inline std::string to_string(string_view text) {return std::string(text);}
}  // namespace nonstd
