// Messages as the structures and clouds of the Point Cloud Library, and back. `move...` leaves the source without its data.
#pragma once
#include <pcl/ModelCoefficients.h>
#include <pcl/PCLHeader.h>
#include <pcl/PCLImage.h>
#include <pcl/PCLPointCloud2.h>
#include <pcl/PCLPointField.h>
#include <pcl/PointIndices.h>
#include <pcl/PolygonMesh.h>
#include <pcl/Vertices.h>
#include <pcl/conversions.h>
#include <pcl/io/pcd_io.h>
#include <pcl/point_cloud.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "pcl_msgs/msg/model_coefficients.hpp"
#include "pcl_msgs/msg/point_indices.hpp"
#include "pcl_msgs/msg/polygon_mesh.hpp"
#include "pcl_msgs/msg/vertices.hpp"
#include "rclcpp/time.hpp"
#include "sensor_msgs/msg/image.hpp"
#include "sensor_msgs/msg/point_cloud2.hpp"
#include "sensor_msgs/msg/point_field.hpp"
#include "std_msgs/msg/header.hpp"

namespace pcl_conversions
{
/// PCL's stamps are in microseconds.
inline void fromPCL(const std::uint64_t & pcl_stamp, rclcpp::Time & stamp)
{
  stamp = rclcpp::Time(static_cast<rcl_time_point_value_t>(pcl_stamp * 1000));
}
inline void toPCL(const rclcpp::Time & stamp, std::uint64_t & pcl_stamp)
{
  pcl_stamp = static_cast<std::uint64_t>(stamp.nanoseconds() / 1000);
}
inline rclcpp::Time fromPCL(const std::uint64_t & pcl_stamp)
{
  rclcpp::Time stamp;
  fromPCL(pcl_stamp, stamp);
  return stamp;
}
inline std::uint64_t toPCL(const rclcpp::Time & stamp)
{
  std::uint64_t pcl_stamp;
  toPCL(stamp, pcl_stamp);
  return pcl_stamp;
}

inline void fromPCL(const pcl::PCLHeader & pcl_header, std_msgs::msg::Header & header)
{
  header.stamp = fromPCL(pcl_header.stamp);
  header.frame_id = pcl_header.frame_id;
}
inline void toPCL(const std_msgs::msg::Header & header, pcl::PCLHeader & pcl_header)
{
  toPCL(rclcpp::Time(header.stamp), pcl_header.stamp);
  pcl_header.seq = 0;  // headers of ROS 2 are not numbered
  pcl_header.frame_id = header.frame_id;
}
inline std_msgs::msg::Header fromPCL(const pcl::PCLHeader & pcl_header)
{
  std_msgs::msg::Header header;
  fromPCL(pcl_header, header);
  return header;
}
inline pcl::PCLHeader toPCL(const std_msgs::msg::Header & header)
{
  pcl::PCLHeader pcl_header;
  toPCL(header, pcl_header);
  return pcl_header;
}

inline void fromPCL(const pcl::PCLPointField & pcl_field, sensor_msgs::msg::PointField & field)
{
  field.name = pcl_field.name;
  field.offset = pcl_field.offset;
  field.datatype = pcl_field.datatype;
  field.count = pcl_field.count;
}
inline void toPCL(const sensor_msgs::msg::PointField & field, pcl::PCLPointField & pcl_field)
{
  pcl_field.name = field.name;
  pcl_field.offset = field.offset;
  pcl_field.datatype = field.datatype;
  pcl_field.count = field.count;
}
inline void fromPCL(const pcl::Vertices & pcl_vertices, pcl_msgs::msg::Vertices & vertices)
{
  vertices.vertices.assign(pcl_vertices.vertices.begin(), pcl_vertices.vertices.end());
}
inline void toPCL(const pcl_msgs::msg::Vertices & vertices, pcl::Vertices & pcl_vertices)
{
  pcl_vertices.vertices.assign(vertices.vertices.begin(), vertices.vertices.end());
}

/// Lists of fields and of vertices.
template<typename Pcl, typename Message>
auto fromPCL(const std::vector<Pcl> & pcl_list, std::vector<Message> & list)
-> decltype(fromPCL(std::declval<const Pcl &>(), std::declval<Message &>()))
{
  list.resize(pcl_list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    fromPCL(pcl_list[i], list[i]);
  }
}
template<typename Message, typename Pcl>
auto toPCL(const std::vector<Message> & list, std::vector<Pcl> & pcl_list)
-> decltype(toPCL(std::declval<const Message &>(), std::declval<Pcl &>()))
{
  pcl_list.resize(list.size());
  for (std::size_t i = 0; i < list.size(); ++i) {
    toPCL(list[i], pcl_list[i]);
  }
}
inline void moveFromPCL(std::vector<pcl::Vertices> & pcl_list, std::vector<pcl_msgs::msg::Vertices> & list)
{
  fromPCL(pcl_list, list);
  pcl_list.clear();
}
inline void moveToPCL(std::vector<pcl_msgs::msg::Vertices> & list, std::vector<pcl::Vertices> & pcl_list)
{
  toPCL(list, pcl_list);
  list.clear();
}

/// All of an image but its data.
inline void copyPCLImageMetaData(const pcl::PCLImage & pcl_image, sensor_msgs::msg::Image & image)
{
  fromPCL(pcl_image.header, image.header);
  image.height = pcl_image.height;
  image.width = pcl_image.width;
  image.encoding = pcl_image.encoding;
  image.is_bigendian = pcl_image.is_bigendian;
  image.step = pcl_image.step;
}
inline void copyImageMetaData(const sensor_msgs::msg::Image & image, pcl::PCLImage & pcl_image)
{
  toPCL(image.header, pcl_image.header);
  pcl_image.height = image.height;
  pcl_image.width = image.width;
  pcl_image.encoding = image.encoding;
  pcl_image.is_bigendian = image.is_bigendian;
  pcl_image.step = image.step;
}
/// All of a cloud but its data.
inline void copyPCLPointCloud2MetaData(const pcl::PCLPointCloud2 & pcl_cloud, sensor_msgs::msg::PointCloud2 & cloud)
{
  fromPCL(pcl_cloud.header, cloud.header);
  cloud.height = pcl_cloud.height;
  cloud.width = pcl_cloud.width;
  fromPCL(pcl_cloud.fields, cloud.fields);
  cloud.is_bigendian = pcl_cloud.is_bigendian;
  cloud.point_step = pcl_cloud.point_step;
  cloud.row_step = pcl_cloud.row_step;
  cloud.is_dense = pcl_cloud.is_dense == 1;
}
inline void copyPointCloud2MetaData(const sensor_msgs::msg::PointCloud2 & cloud, pcl::PCLPointCloud2 & pcl_cloud)
{
  toPCL(cloud.header, pcl_cloud.header);
  pcl_cloud.height = cloud.height;
  pcl_cloud.width = cloud.width;
  toPCL(cloud.fields, pcl_cloud.fields);
  pcl_cloud.is_bigendian = cloud.is_bigendian;
  pcl_cloud.point_step = cloud.point_step;
  pcl_cloud.row_step = cloud.row_step;
  pcl_cloud.is_dense = cloud.is_dense;
}

/// Conversions of a type whose `member` holds the data: copied, or moved.
#define COURSEKIT_PCL_DATA(Pcl, Message, member, metadata_of_pcl, metadata_of_message) \
  inline void fromPCL(const Pcl & from, Message & to) \
  { \
    metadata_of_pcl(from, to); \
    to.member = from.member; \
  } \
  inline void moveFromPCL(Pcl & from, Message & to) \
  { \
    metadata_of_pcl(from, to); \
    to.member = std::move(from.member); \
    from.member.clear(); \
  } \
  inline void toPCL(const Message & from, Pcl & to) \
  { \
    metadata_of_message(from, to); \
    to.member = from.member; \
  } \
  inline void moveToPCL(Message & from, Pcl & to) \
  { \
    metadata_of_message(from, to); \
    to.member = std::move(from.member); \
    from.member.clear(); \
  }

template<typename Pcl, typename Message>
void copyPCLHeader(const Pcl & from, Message & to) {fromPCL(from.header, to.header);}
template<typename Message, typename Pcl>
void copyHeader(const Message & from, Pcl & to) {toPCL(from.header, to.header);}

COURSEKIT_PCL_DATA(
  pcl::PCLImage, sensor_msgs::msg::Image, data, copyPCLImageMetaData, copyImageMetaData)
COURSEKIT_PCL_DATA(
  pcl::PCLPointCloud2, sensor_msgs::msg::PointCloud2, data, copyPCLPointCloud2MetaData, copyPointCloud2MetaData)
COURSEKIT_PCL_DATA(pcl::PointIndices, pcl_msgs::msg::PointIndices, indices, copyPCLHeader, copyHeader)
COURSEKIT_PCL_DATA(pcl::ModelCoefficients, pcl_msgs::msg::ModelCoefficients, values, copyPCLHeader, copyHeader)
#undef COURSEKIT_PCL_DATA

inline void fromPCL(const pcl::PolygonMesh & pcl_mesh, pcl_msgs::msg::PolygonMesh & mesh)
{
  fromPCL(pcl_mesh.header, mesh.header);
  fromPCL(pcl_mesh.cloud, mesh.cloud);
  fromPCL(pcl_mesh.polygons, mesh.polygons);
}
inline void toPCL(const pcl_msgs::msg::PolygonMesh & mesh, pcl::PolygonMesh & pcl_mesh)
{
  toPCL(mesh.header, pcl_mesh.header);
  toPCL(mesh.cloud, pcl_mesh.cloud);
  toPCL(mesh.polygons, pcl_mesh.polygons);
}
inline void moveFromPCL(pcl::PolygonMesh & pcl_mesh, pcl_msgs::msg::PolygonMesh & mesh)
{
  fromPCL(pcl_mesh.header, mesh.header);
  moveFromPCL(pcl_mesh.cloud, mesh.cloud);
  moveFromPCL(pcl_mesh.polygons, mesh.polygons);
}
inline void moveToPCL(pcl_msgs::msg::PolygonMesh & mesh, pcl::PolygonMesh & pcl_mesh)
{
  toPCL(mesh.header, pcl_mesh.header);
  moveToPCL(mesh.cloud, pcl_mesh.cloud);
  moveToPCL(mesh.polygons, pcl_mesh.polygons);
}
}  // namespace pcl_conversions

namespace pcl
{
/// A field's index; -1 where the cloud has none of that name.
inline int getFieldIndex(const sensor_msgs::msg::PointCloud2 & cloud, const std::string & field_name)
{
  for (std::size_t i = 0; i < cloud.fields.size(); ++i) {
    if (cloud.fields[i].name == field_name) {
      return static_cast<int>(i);
    }
  }
  return -1;
}
/// The names of a cloud's fields, with spaces between.
inline std::string getFieldsList(const sensor_msgs::msg::PointCloud2 & cloud)
{
  std::string names;
  for (const auto & field : cloud.fields) {
    names += (names.empty() ? "" : " ") + field.name;
  }
  return names;
}

template<typename PointT>
void createMapping(const std::vector<sensor_msgs::msg::PointField> & fields, MsgFieldMap & field_map)
{
  std::vector<PCLPointField> pcl_fields;
  pcl_conversions::toPCL(fields, pcl_fields);
  return createMapping<PointT>(pcl_fields, field_map);
}

template<typename T>
void toROSMsg(const PointCloud<T> & pcl_cloud, sensor_msgs::msg::PointCloud2 & cloud)
{
  PCLPointCloud2 between;
  toPCLPointCloud2(pcl_cloud, between);
  pcl_conversions::moveFromPCL(between, cloud);
}
template<typename T>
void fromROSMsg(const sensor_msgs::msg::PointCloud2 & cloud, PointCloud<T> & pcl_cloud)
{
  PCLPointCloud2 between;
  pcl_conversions::toPCL(cloud, between);
  fromPCLPointCloud2(between, pcl_cloud);
}
template<typename T>
void moveFromROSMsg(sensor_msgs::msg::PointCloud2 & cloud, PointCloud<T> & pcl_cloud)
{
  PCLPointCloud2 between;
  pcl_conversions::moveToPCL(cloud, between);
  fromPCLPointCloud2(between, pcl_cloud);
}
/// The colours of an ordered cloud, its field `rgb`, as an image.
inline void toROSMsg(const sensor_msgs::msg::PointCloud2 & cloud, sensor_msgs::msg::Image & image)
{
  PCLPointCloud2 between;
  pcl_conversions::toPCL(cloud, between);
  PCLImage pcl_image;
  toPCLPointCloud2(between, pcl_image);
  pcl_conversions::moveFromPCL(pcl_image, image);
}
template<typename CloudT>
void toROSMsg(const CloudT & cloud, sensor_msgs::msg::Image & image)
{
  PCLImage pcl_image;
  toPCLPointCloud2(cloud, pcl_image);
  pcl_conversions::moveFromPCL(pcl_image, image);
}

/// Both clouds' points in one, which needs the same fields; false where they differ.
inline bool concatenatePointCloud(
  const sensor_msgs::msg::PointCloud2 & first, const sensor_msgs::msg::PointCloud2 & second,
  sensor_msgs::msg::PointCloud2 & both)
{
  PCLPointCloud2 pcl_first, pcl_second, pcl_both;
  pcl_conversions::toPCL(first, pcl_first);
  pcl_conversions::toPCL(second, pcl_second);
  if (!PCLPointCloud2::concatenate(pcl_first, pcl_second, pcl_both)) {
    return false;
  }
  pcl_conversions::moveFromPCL(pcl_both, both);
  return true;
}

namespace io
{
inline int savePCDFile(
  const std::string & file_name, const sensor_msgs::msg::PointCloud2 & cloud,
  const Eigen::Vector4f & origin = Eigen::Vector4f::Zero(),
  const Eigen::Quaternionf & orientation = Eigen::Quaternionf::Identity(), const bool binary_mode = false)
{
  PCLPointCloud2 pcl_cloud;
  pcl_conversions::toPCL(cloud, pcl_cloud);
  return savePCDFile(file_name, pcl_cloud, origin, orientation, binary_mode);
}
inline int destructiveSavePCDFile(
  const std::string & file_name, sensor_msgs::msg::PointCloud2 & cloud,
  const Eigen::Vector4f & origin = Eigen::Vector4f::Zero(),
  const Eigen::Quaternionf & orientation = Eigen::Quaternionf::Identity(), const bool binary_mode = false)
{
  PCLPointCloud2 pcl_cloud;
  pcl_conversions::moveToPCL(cloud, pcl_cloud);
  return savePCDFile(file_name, pcl_cloud, origin, orientation, binary_mode);
}
inline int loadPCDFile(const std::string & file_name, sensor_msgs::msg::PointCloud2 & cloud)
{
  PCLPointCloud2 pcl_cloud;
  const int result = loadPCDFile(file_name, pcl_cloud);
  pcl_conversions::moveFromPCL(pcl_cloud, cloud);
  return result;
}
}  // namespace io
}  // namespace pcl
