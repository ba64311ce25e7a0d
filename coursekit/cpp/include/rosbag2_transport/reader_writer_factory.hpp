// Makes readers and writers for bags, whatever they are stored in, compressed or not.
#pragma once
#include "rosbag2_compression/sequential_compression_writer.hpp"
#include "rosbag2_cpp/reader.hpp"
#include "rosbag2_cpp/writer.hpp"
#include "rosbag2_transport/record_options.hpp"

namespace rosbag2_transport
{
class ReaderWriterFactory
{
public:
  /// A reader that is not open yet; upstream looks here whether the bag is compressed, which ours sees when it opens one.
  static std::unique_ptr<rosbag2_cpp::Reader> make_reader(const rosbag2_storage::StorageOptions &)
  {
    return std::make_unique<rosbag2_cpp::Reader>();
  }
  /// A writer that is not open yet, and compresses where the options name a format.
  static std::unique_ptr<rosbag2_cpp::Writer> make_writer(const RecordOptions & options)
  {
    if (options.compression_format.empty()) {
      return std::make_unique<rosbag2_cpp::Writer>();
    }
    const rosbag2_compression::CompressionOptions packing{
      options.compression_format, rosbag2_compression::compression_mode_from_string(options.compression_mode),
      options.compression_queue_size, options.compression_threads};
    return std::make_unique<rosbag2_cpp::Writer>(std::make_unique<rosbag2_compression::SequentialCompressionWriter>(packing));
  }
};
}  // namespace rosbag2_transport
