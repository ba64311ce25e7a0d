// A text taken apart.
#pragma once
#include <iterator>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace rcpputils
{
/// Give each part to an iterator that inserts it somewhere.
template<
  class Inserter,
  std::enable_if_t<std::is_same_v<Inserter &, decltype(std::declval<Inserter>() = std::declval<std::string>())>> * = nullptr>
void split(const std::string & text, char delimiter, Inserter & inserter, bool skip_empty = false)
{
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, delimiter); ) {
    if (!skip_empty || !part.empty()) {
      inserter = part;
    }
  }
}
inline std::vector<std::string> split(const std::string & text, char delimiter, bool skip_empty = false)
{
  std::vector<std::string> parts;
  auto inserter = std::back_inserter(parts);
  split(text, delimiter, inserter, skip_empty);
  return parts;
}
}  // namespace rcpputils
