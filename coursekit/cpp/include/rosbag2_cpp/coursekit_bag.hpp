// A bag that the session reads or writes for a program.
#pragma once
#include <stdexcept>

#include "coursekit/entity.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rmw/rmw.h"
#include "rosbag2_cpp/converter_options.hpp"
#include "rosbag2_storage/bag_metadata.hpp"
#include "rosbag2_storage/serialized_bag_message.hpp"
#include "rosbag2_storage/storage_options.hpp"

namespace rosbag2_cpp
{
/// Asks the session; what it refuses is a std::runtime_error, as rosbag2 throws it.
class CoursekitBag : private coursekit::Entity
{
protected:
  explicit CoursekitBag(const char * make, const coursekit::Packer & with = coursekit::Packer())
  {
    id = coursekit::request(make, with).i();
  }
  coursekit::Packer bag() const {return coursekit::Packer{}.i(id);}
  static coursekit::Unpacker ask(const char * what, const coursekit::Packer & with)
  {
    try {
      return coursekit::request(what, with);
    } catch (const coursekit::Refused & refused) {
      throw std::runtime_error(refused.what());
    }
  }
  void open_bag(const rosbag2_storage::StorageOptions & storage, const ConverterOptions & converter)
  {
    ask(
      "bag_open", bag().s(storage.uri).s(storage.storage_id).i(static_cast<int64_t>(storage.max_bagfile_size))
      .i(static_cast<int64_t>(storage.max_bagfile_duration)).i(static_cast<int64_t>(storage.max_cache_size))
      .s(storage.storage_preset_profile).s(storage.storage_config_uri).i(storage.snapshot_mode)
      .s(converter.input_serialization_format).s(converter.output_serialization_format));
  }
  void close_bag() {ask("bag_close", bag());}
  /// For destructors, which must not throw: the session may be gone.
  void let_go() noexcept
  {
    try {
      close_bag();
    } catch (...) {
    }
  }
};
}  // namespace rosbag2_cpp
