// A text taken apart.
#pragma once
#include <sstream>
#include <string>
#include <vector>

namespace rcpputils
{
inline std::vector<std::string> split(const std::string & text, char delimiter, bool skip_empty = false)
{
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, delimiter); ) {
    if (!skip_empty || !part.empty()) {
      parts.push_back(part);
    }
  }
  return parts;
}
}  // namespace rcpputils
