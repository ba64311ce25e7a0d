// A message of a bag: the bytes that travelled, when, and on which topic.
#pragma once
#include <memory>
#include <string>

#include "rclcpp/serialized_message.hpp"

typedef int64_t rcutils_time_point_value_t;

namespace rosbag2_storage
{
struct SerializedBagMessage
{
  std::shared_ptr<rcutils_uint8_array_t> serialized_data;
  rcutils_time_point_value_t time_stamp = 0;
  std::string topic_name;
};
typedef std::shared_ptr<SerializedBagMessage> SerializedBagMessageSharedPtr;
typedef std::shared_ptr<const SerializedBagMessage> SerializedBagMessageConstSharedPtr;
}  // namespace rosbag2_storage
