// The old PointCloud, a list of points with channels, as a PointCloud2, and back.
#pragma once
#include <string>

#include "sensor_msgs/msg/point_cloud.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_field_conversion.hpp"

namespace sensor_msgs
{
/// The place of a field among a cloud's; -1 where it has none of that name.
inline int getPointCloud2FieldIndex(const msg::PointCloud2 & cloud, const std::string & field_name)
{
  for (size_t i = 0; i < cloud.fields.size(); ++i) {
    if (cloud.fields[i].name == field_name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}
inline bool convertPointCloudToPointCloud2(const msg::PointCloud & input, msg::PointCloud2 & output)
{
  output.header = input.header;
  output.width = static_cast<uint32_t>(input.points.size());
  output.height = 1;
  output.is_bigendian = false;
  output.is_dense = false;
  output.fields.clear();
  const char * axes[] = {"x", "y", "z"};
  for (size_t i = 0; i < 3 + input.channels.size(); ++i) {
    msg::PointField field;
    field.name = i < 3 ? axes[i] : input.channels[i - 3].name;
    field.offset = static_cast<uint32_t>(4 * i);
    field.datatype = msg::PointField::FLOAT32;
    field.count = 1;
    output.fields.push_back(field);
  }
  output.point_step = static_cast<uint32_t>(4 * output.fields.size());
  output.row_step = output.point_step * output.width;
  output.data.resize(output.row_step);
  for (size_t i = 0; i < input.points.size(); ++i) {
    unsigned char * at = output.data.data() + i * output.point_step;
    const float position[] = {input.points[i].x, input.points[i].y, input.points[i].z};
    std::memcpy(at, position, sizeof(position));
    for (size_t channel = 0; channel < input.channels.size(); ++channel) {
      if (i < input.channels[channel].values.size()) {
        std::memcpy(at + 12 + 4 * channel, &input.channels[channel].values[i], 4);
      }
    }
  }
  return true;
}
/// False where the cloud has no x, y and z.
inline bool convertPointCloud2ToPointCloud(const msg::PointCloud2 & input, msg::PointCloud & output)
{
  const int x = getPointCloud2FieldIndex(input, "x"), y = getPointCloud2FieldIndex(input, "y");
  const int z = getPointCloud2FieldIndex(input, "z");
  if (x < 0 || y < 0 || z < 0) {
    return false;
  }
  const size_t count = static_cast<size_t>(input.width) * input.height;
  auto number = [&](size_t point, int field) {
      auto & of = input.fields[static_cast<size_t>(field)];
      return readPointCloud2BufferValue<float>(&input.data[point * input.point_step + of.offset], of.datatype);
    };
  output.header = input.header;
  output.points.resize(count);
  output.channels.clear();
  for (size_t i = 0; i < count; ++i) {
    output.points[i].x = number(i, x);
    output.points[i].y = number(i, y);
    output.points[i].z = number(i, z);
  }
  for (int field = 0; field < static_cast<int>(input.fields.size()); ++field) {
    if (field != x && field != y && field != z) {
      output.channels.emplace_back();
      output.channels.back().name = input.fields[static_cast<size_t>(field)].name;
      for (size_t i = 0; i < count; ++i) {
        output.channels.back().values.push_back(number(i, field));
      }
    }
  }
  return true;
}
}  // namespace sensor_msgs
