#pragma once
#include "image_transport/camera.hpp"

namespace image_transport
{
/// A text without the last place where another is in it.
inline std::string erase_last_copy(const std::string & input, const std::string & search)
{
  const size_t at = input.rfind(search);
  return at == std::string::npos ? input : std::string(input).erase(at, search.size());
}
}  // namespace image_transport
