// How a bag is compressed.
#pragma once
#include <cctype>
#include <cstdint>
#include <string>

namespace rosbag2_compression
{
enum class CompressionMode : uint32_t {NONE = 0, FILE, MESSAGE, LAST_MODE = MESSAGE};

struct CompressionOptions
{
  std::string compression_format;
  CompressionMode compression_mode = CompressionMode::NONE;
  uint64_t compression_queue_size = 0;
  uint64_t compression_threads = 0;
};
inline std::string compression_mode_to_string(CompressionMode mode)
{
  return mode == CompressionMode::FILE ? "FILE" : mode == CompressionMode::MESSAGE ? "MESSAGE" : "NONE";
}
/// What is no mode's name, in whatever case, is NONE.
inline CompressionMode compression_mode_from_string(const std::string & text)
{
  std::string name;
  for (unsigned char letter : text) {
    name += static_cast<char>(std::toupper(letter));
  }
  return name == "FILE" ? CompressionMode::FILE : name == "MESSAGE" ? CompressionMode::MESSAGE : CompressionMode::NONE;
}
}  // namespace rosbag2_compression
