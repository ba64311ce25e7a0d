// Clouds into other frames: by a transform, or by the one that a tf2 buffer has at the cloud's time.
#pragma once
#include <pcl/common/transforms.h>
#include <pcl/point_cloud.h>

#include <Eigen/Core>
#include <string>

#include "geometry_msgs/msg/transform.hpp"
#include "geometry_msgs/msg/transform_stamped.hpp"
#include "pcl_conversions/pcl_conversions.h"
#include "rclcpp/logging.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/point_cloud2_iterator.hpp"
#include "tf2/LinearMath/Transform.h"
#include "tf2_geometry_msgs/tf2_geometry_msgs.hpp"
#include "tf2_ros/buffer.h"

namespace pcl_ros
{
inline void transformAsMatrix(const tf2::Transform & transform, Eigen::Matrix4f & matrix)
{
  matrix.setIdentity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      matrix(row, column) = static_cast<float>(transform.getBasis()[row][column]);
    }
    matrix(row, 3) = static_cast<float>(transform.getOrigin()[row]);
  }
}
inline void transformAsMatrix(const geometry_msgs::msg::TransformStamped & transform, Eigen::Matrix4f & matrix)
{
  tf2::Transform motion;
  tf2::fromMsg(transform.transform, motion);
  transformAsMatrix(motion, matrix);
}

/// The transform that `look_up` returns; false, and a line of the log, where the buffer has none.
template<typename LookUp>
bool try_lookup(const LookUp & look_up, geometry_msgs::msg::TransformStamped & transform)
{
  try {
    transform = look_up();
    return true;
  } catch (const tf2::LookupException & error) {
    RCLCPP_ERROR(rclcpp::get_logger("pcl_ros"), "%s", error.what());
  } catch (const tf2::ExtrapolationException & error) {
    RCLCPP_ERROR(rclcpp::get_logger("pcl_ros"), "%s", error.what());
  }
  return false;
}

#define COURSEKIT_PCL_TRANSFORM(name) \
  template<typename PointT> \
  void name(const pcl::PointCloud<PointT> & in, pcl::PointCloud<PointT> & out, const tf2::Transform & transform) \
  { \
    Eigen::Matrix4f matrix; \
    transformAsMatrix(transform, matrix); \
    pcl::name(in, out, matrix); \
  } \
  template<typename PointT> \
  void name( \
    const pcl::PointCloud<PointT> & in, pcl::PointCloud<PointT> & out, \
    const geometry_msgs::msg::TransformStamped & transform) \
  { \
    tf2::Transform motion; \
    tf2::fromMsg(transform.transform, motion); \
    name(in, out, motion); \
  } \
  template<typename PointT> \
  bool name( \
    const std::string & target_frame, const pcl::PointCloud<PointT> & in, pcl::PointCloud<PointT> & out, \
    const tf2_ros::Buffer & tf_buffer) \
  { \
    if (in.header.frame_id == target_frame) { \
      out = in; \
      return true; \
    } \
    const auto look_up = [&] { \
        return tf_buffer.lookupTransform( \
          target_frame, in.header.frame_id, tf2_ros::fromRclcpp(pcl_conversions::fromPCL(in.header.stamp))); \
      }; \
    geometry_msgs::msg::TransformStamped transform; \
    if (!try_lookup(look_up, transform)) { \
      return false; \
    } \
    name(in, out, transform); \
    out.header.frame_id = target_frame; \
    return true; \
  } \
  template<typename PointT> \
  bool name( \
    const std::string & target_frame, const rclcpp::Time & target_time, const pcl::PointCloud<PointT> & in, \
    const std::string & fixed_frame, pcl::PointCloud<PointT> & out, const tf2_ros::Buffer & tf_buffer) \
  { \
    const auto look_up = [&] { \
        return tf_buffer.lookupTransform( \
          target_frame, tf2_ros::fromRclcpp(target_time), in.header.frame_id, \
          tf2_ros::fromRclcpp(pcl_conversions::fromPCL(in.header.stamp)), fixed_frame); \
      }; \
    geometry_msgs::msg::TransformStamped transform; \
    if (!try_lookup(look_up, transform)) { \
      return false; \
    } \
    name(in, out, transform); \
    out.header.frame_id = target_frame; \
    pcl_conversions::toPCL(target_time, out.header.stamp); \
    return true; \
  }
COURSEKIT_PCL_TRANSFORM(transformPointCloud)
COURSEKIT_PCL_TRANSFORM(transformPointCloudWithNormals)
#undef COURSEKIT_PCL_TRANSFORM

/// Moves the points of three fields, which must be floats; false where the cloud has none of the first name.
inline bool move_field(
  const Eigen::Matrix4f & matrix, sensor_msgs::msg::PointCloud2 & cloud, const std::string & x, const std::string & y,
  const std::string & z)
{
  const int index = pcl::getFieldIndex(cloud, x);
  if (index < 0 || pcl::getFieldIndex(cloud, y) < 0 || pcl::getFieldIndex(cloud, z) < 0) {
    return false;
  }
  if (cloud.fields[index].datatype != sensor_msgs::msg::PointField::FLOAT32) {
    RCLCPP_ERROR(
      rclcpp::get_logger("pcl_ros"), "X-Y-Z coordinates not floats. Currently only floats are supported.");
    return true;
  }
  sensor_msgs::PointCloud2Iterator<float> at_x(cloud, x), at_y(cloud, y), at_z(cloud, z);
  for (; at_x != at_x.end(); ++at_x, ++at_y, ++at_z) {
    const Eigen::Vector4f moved = matrix * Eigen::Vector4f(*at_x, *at_y, *at_z, 1.0f);
    if (moved.allFinite()) {  // points that were not measured stay as they are
      *at_x = moved.x();
      *at_y = moved.y();
      *at_z = moved.z();
    }
  }
  return true;
}

/// A message's points, and its view point where it has one; other fields stay as they are, normals too.
inline void transformPointCloud(
  const Eigen::Matrix4f & matrix, const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out)
{
  if (&in != &out) {
    out = in;
  }
  if (!move_field(matrix, out, "x", "y", "z")) {
    RCLCPP_ERROR(
      rclcpp::get_logger("pcl_ros"), "Input dataset has no X-Y-Z coordinates! Cannot convert to Eigen format.");
    return;
  }
  move_field(matrix, out, "vp_x", "vp_y", "vp_z");
}
inline void transformPointCloud(
  const std::string & target_frame, const tf2::Transform & transform, const sensor_msgs::msg::PointCloud2 & in,
  sensor_msgs::msg::PointCloud2 & out)
{
  if (in.header.frame_id == target_frame) {
    out = in;
    return;
  }
  Eigen::Matrix4f matrix;
  transformAsMatrix(transform, matrix);
  transformPointCloud(matrix, in, out);
  out.header.frame_id = target_frame;
}
inline void transformPointCloud(
  const std::string & target_frame, const geometry_msgs::msg::TransformStamped & transform,
  const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out)
{
  tf2::Transform motion;
  tf2::fromMsg(transform.transform, motion);
  transformPointCloud(target_frame, motion, in, out);
}
/// By the transform of a buffer, which may come within a second.
inline bool transformPointCloud(
  const std::string & target_frame, const sensor_msgs::msg::PointCloud2 & in, sensor_msgs::msg::PointCloud2 & out,
  const tf2_ros::Buffer & tf_buffer)
{
  const auto look_up = [&] {
      return tf_buffer.lookupTransform(
        target_frame, in.header.frame_id, tf2_ros::fromRclcpp(in.header.stamp), tf2::Duration(std::chrono::seconds(1)));
    };
  geometry_msgs::msg::TransformStamped transform;
  if (in.header.frame_id != target_frame && !try_lookup(look_up, transform)) {
    return false;
  }
  transformPointCloud(target_frame, transform, in, out);
  return true;
}
}  // namespace pcl_ros
