// Writes a compressed bag.
#pragma once
#include "rosbag2_compression/compression_options.hpp"
#include "rosbag2_cpp/writers/sequential_writer.hpp"

namespace rosbag2_compression
{
class SequentialCompressionWriter : public rosbag2_cpp::writers::SequentialWriter
{
public:
  explicit SequentialCompressionWriter(const CompressionOptions & options = CompressionOptions())
  : SequentialWriter(options.compression_format, compression_mode_to_string(options.compression_mode)) {}
};
}  // namespace rosbag2_compression
