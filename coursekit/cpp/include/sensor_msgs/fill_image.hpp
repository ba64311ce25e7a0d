// Images out of rows of bytes.
#pragma once
#include <string>

#include "sensor_msgs/image_encodings.hpp"
#include "sensor_msgs/msg/image.hpp"

namespace sensor_msgs
{
/// Fill an image with `rows` rows of `step` bytes each.
inline bool fillImage(
  msg::Image & image, const std::string & encoding, uint32_t rows, uint32_t cols, uint32_t step, const void * data)
{
  image.encoding = encoding;
  image.height = rows;
  image.width = cols;
  image.step = step;
  auto bytes = static_cast<const uint8_t *>(data);
  image.data.assign(bytes, bytes + static_cast<size_t>(step) * rows);
  image.is_bigendian = 0;
  return true;
}
/// Empty it.
inline void clearImage(msg::Image & image) {image.data.resize(0);}
}  // namespace sensor_msgs
