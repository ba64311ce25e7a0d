// Reads a compressed bag; whether one is compressed is in its metadata, which any reader looks at.
#pragma once
#include "rosbag2_compression/compression_options.hpp"
#include "rosbag2_cpp/readers/sequential_reader.hpp"

namespace rosbag2_compression
{
class SequentialCompressionReader : public rosbag2_cpp::readers::SequentialReader {};
}  // namespace rosbag2_compression
