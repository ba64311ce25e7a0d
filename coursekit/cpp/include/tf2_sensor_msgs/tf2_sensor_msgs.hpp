// Point clouds through a transform.
#pragma once
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"

namespace tf2
{
template<>
inline TimePoint getTimestamp(const sensor_msgs::msg::PointCloud2 & cloud) {return time_of(cloud.header);}
template<>
inline std::string getFrameId(const sensor_msgs::msg::PointCloud2 & cloud) {return cloud.header.frame_id;}
/// The cloud in the transform's frame; fields besides x, y and z stay as they are.
template<>
inline void doTransform(
  const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out,
  const geometry_msgs::msg::TransformStamped & transform)
{
  Transform motion;
  fromMsg(transform.transform, motion);
  out = in;
  out.header = transform.header;
  sensor_msgs::PointCloud2Iterator<float> x(out, "x"), y(out, "y"), z(out, "z");
  for (; x != x.end(); ++x, ++y, ++z) {
    Vector3 place = motion * Vector3(*x, *y, *z);
    *x = static_cast<float>(place.x());
    *y = static_cast<float>(place.y());
    *z = static_cast<float>(place.z());
  }
}
}  // namespace tf2
