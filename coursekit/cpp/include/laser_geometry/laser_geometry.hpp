// Where the beams of a laser scan end, as a cloud of points.
#pragma once
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "sensor_msgs/msg/laser_scan.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2_ros/buffer.h"

namespace laser_geometry
{
const float LASER_SCAN_INVALID = -1.0f;
const float LASER_SCAN_MIN_RANGE = -2.0f;
const float LASER_SCAN_MAX_RANGE = -3.0f;

namespace channel_option
{
/// What is told of a point beside its place; add them up.
enum ChannelOption
{
  None = 0x00, Intensity = 0x01, Index = 0x02, Distance = 0x04, Timestamp = 0x08, Viewpoint = 0x10,
  Default = Intensity | Index
};
}  // namespace channel_option

class LaserProjection
{
public:
  using LaserScan = sensor_msgs::msg::LaserScan;
  using PointCloud2 = sensor_msgs::msg::PointCloud2;

  /// The points in the scan's own frame; those beyond range_cutoff [m] (negative: range_max) are left out.
  void projectLaser(
    const LaserScan & scan_in, PointCloud2 & cloud_out, double range_cutoff = -1.0,
    int channel_options = channel_option::Default)
  {
    project(scan_in, cloud_out, range_cutoff, channel_options, [](size_t) {return tf2::Transform::getIdentity();});
  }
  /// The points in another frame, each from where the scanner was at its time; throws as Buffer::lookupTransform.
  template<class Buffer>
  void transformLaserScanToPointCloud(
    const std::string & target_frame, const LaserScan & scan_in, PointCloud2 & cloud_out, Buffer & tf,
    double range_cutoff = -1.0, int channel_options = channel_option::Default)
  {
    size_t count = scan_in.ranges.size();
    rclcpp::Time start(scan_in.header.stamp);
    rclcpp::Time end = start + rclcpp::Duration::from_seconds(count ? (count - 1.0) * scan_in.time_increment : 0.0);
    tf2::Transform first = looked_up(tf, target_frame, scan_in.header.frame_id, start);
    tf2::Transform last = looked_up(tf, target_frame, scan_in.header.frame_id, end);
    project(
      scan_in, cloud_out, range_cutoff, channel_options, [&](size_t index) {
        double part = count > 1 ? static_cast<double>(index) / static_cast<double>(count - 1) : 0.0;
        return tf2::Transform(
          tf2::slerp(first.getRotation(), last.getRotation(), part), tf2::lerp(first.getOrigin(), last.getOrigin(), part));
      });
    cloud_out.header.frame_id = target_frame;
  }

private:
  using Field = sensor_msgs::msg::PointField;
  static void add(PointCloud2 & cloud, const char * name, uint8_t type = Field::FLOAT32)
  {
    Field field;
    field.name = name;
    field.offset = cloud.point_step;
    field.datatype = type;
    field.count = 1;
    cloud.fields.push_back(field);
    cloud.point_step += 4;
  }
  static void describe(const LaserScan & scan, PointCloud2 & cloud, int options)
  {
    for (auto name : {"x", "y", "z"}) {
      add(cloud, name);
    }
    if (options & channel_option::Intensity && !scan.intensities.empty()) {
      add(cloud, "intensity");
    }
    if (options & channel_option::Index) {
      add(cloud, "index", Field::INT32);
    }
    if (options & channel_option::Distance) {
      add(cloud, "distances");
    }
    if (options & channel_option::Timestamp) {
      add(cloud, "stamps");
    }
    if (options & channel_option::Viewpoint) {
      for (auto name : {"vp_x", "vp_y", "vp_z"}) {
        add(cloud, name);
      }
    }
  }
  template<class F>
  static void project(const LaserScan & scan, PointCloud2 & cloud, double cutoff, int options, F transform_at)
  {
    cloud = PointCloud2();
    cloud.header = scan.header;
    describe(scan, cloud, options);
    double farthest = cutoff < 0 ? static_cast<double>(scan.range_max) : cutoff;
    for (size_t i = 0; i < scan.ranges.size(); ++i) {
      double range = scan.ranges[i];
      if (range < farthest && range >= scan.range_min) {
        append(scan, cloud, i, transform_at(i));
      }
    }
    cloud.height = 1;
    cloud.width = static_cast<uint32_t>(cloud.data.size() / cloud.point_step);
    cloud.row_step = cloud.point_step * cloud.width;
    cloud.is_dense = false;
  }
  static void append(const LaserScan & scan, PointCloud2 & cloud, size_t i, const tf2::Transform & transform)
  {
    double angle = scan.angle_min + static_cast<double>(i) * scan.angle_increment, range = scan.ranges[i];
    tf2::Vector3 place = transform * tf2::Vector3(range * std::cos(angle), range * std::sin(angle), 0);
    tf2::Vector3 from = transform.getOrigin();
    size_t at = cloud.data.size();
    cloud.data.resize(at + cloud.point_step);
    auto put = [&](const auto & value) {
        std::memcpy(cloud.data.data() + at, &value, 4);
        at += 4;
      };
    for (auto & field : cloud.fields) {
      const std::string & name = field.name;
      if (name == "index") {
        put(static_cast<int32_t>(i));
      } else {
        put(number(scan, name, i, place, from));
      }
    }
  }
  static float number(
    const LaserScan & scan, const std::string & name, size_t i, const tf2::Vector3 & place, const tf2::Vector3 & from)
  {
    char axis = name.back();
    if (name.size() == 1 || name.compare(0, 3, "vp_") == 0) {
      const tf2::Vector3 & v = name.size() == 1 ? place : from;
      return static_cast<float>(axis == 'x' ? v.x() : axis == 'y' ? v.y() : v.z());
    }
    if (name == "intensity") {
      return i < scan.intensities.size() ? scan.intensities[i] : 0.0f;
    }
    return name == "distances" ? scan.ranges[i] : static_cast<float>(i) * scan.time_increment;
  }
  template<class Buffer>
  static tf2::Transform looked_up(
    Buffer & tf, const std::string & target, const std::string & source, const rclcpp::Time & time)
  {
    const tf2::TimePoint point(std::chrono::nanoseconds(time.nanoseconds()));
    auto found = tf.lookupTransform(target, source, point).transform;
    auto & r = found.rotation;
    auto & t = found.translation;
    return tf2::Transform(tf2::Quaternion(r.x, r.y, r.z, r.w), tf2::Vector3(t.x, t.y, t.z));
  }
};
}  // namespace laser_geometry
