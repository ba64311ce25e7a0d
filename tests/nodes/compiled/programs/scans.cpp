// laser_geometry: the clouds of a scan, printed as fields and numbers.
#include <iostream>

#include "laser_geometry/laser_geometry.hpp"
#include "rclcpp/rclcpp.hpp"
#include "tf2_ros/buffer.h"

static void print(const sensor_msgs::msg::PointCloud2 & cloud)
{
  std::cout << cloud.header.frame_id << " " << cloud.width << " " << cloud.point_step << cloud.is_dense;
  for (auto & field : cloud.fields) {
    std::cout << " " << field.name << field.offset;
  }
  std::cout << std::hex;
  for (uint8_t byte : cloud.data) {
    std::cout << " " << int(byte);
  }
  std::cout << std::dec << std::endl;
}
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  sensor_msgs::msg::LaserScan scan;
  scan.header.frame_id = "laser";
  scan.header.stamp.sec = 100;
  scan.angle_min = -1.0f;
  scan.angle_increment = 0.5f;
  scan.time_increment = 0.25f;
  scan.range_min = 0.1f;
  scan.range_max = 10.0f;
  scan.ranges = {1.0f, 0.05f, 2.5f, 20.0f, 4.0f};
  scan.intensities = {5, 6, 7, 8, 9};
  laser_geometry::LaserProjection projection;
  sensor_msgs::msg::PointCloud2 cloud;
  projection.projectLaser(scan, cloud);
  print(cloud);
  namespace option = laser_geometry::channel_option;
  projection.projectLaser(scan, cloud, 3.0, option::Distance | option::Timestamp);
  print(cloud);

  tf2_ros::Buffer buffer(std::make_shared<rclcpp::Clock>(RCL_ROS_TIME));
  geometry_msgs::msg::TransformStamped transform;
  transform.header.frame_id = "map";
  transform.child_frame_id = "laser";
  for (int second : {100, 101}) {
    transform.header.stamp.sec = second;
    transform.transform.translation.x = second;
    buffer.setTransform(transform, "test");
  }
  scan.ranges = {1.0f, 1.0f, 1.0f, 1.0f, 1.0f};
  scan.angle_min = 0.0f;
  scan.angle_increment = 0.0f;
  projection.transformLaserScanToPointCloud("map", scan, cloud, buffer);
  std::cout << cloud.header.frame_id;
  for (uint32_t i = 0; i < cloud.width; ++i) {
    float x;
    std::memcpy(&x, &cloud.data[i * cloud.point_step], 4);
    std::cout << " " << x;
  }
  std::cout << std::endl;
  rclcpp::shutdown();
}
