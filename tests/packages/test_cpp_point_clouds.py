"""Packages in C++ that work on point clouds with the system's PCL: conversions, filters, clouds into other frames."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_libraries import built, lay_out
from tests.packages.test_cpp_workspace import colcon, scripted, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]
CMAKE = """
find_package(rclcpp REQUIRED)
find_package(sensor_msgs REQUIRED)
find_package(pcl_conversions REQUIRED)
find_package(pcl_ros REQUIRED)
find_package(PCL REQUIRED COMPONENTS common filters)
add_executable(converts src/converts.cpp)
ament_target_dependencies(converts rclcpp sensor_msgs pcl_conversions)
add_executable(thins src/thins.cpp)
target_include_directories(thins PRIVATE ${PCL_INCLUDE_DIRS})
target_link_libraries(thins ${PCL_LIBRARIES})
ament_target_dependencies(thins rclcpp sensor_msgs pcl_ros)
install(TARGETS converts thins DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
CONVERTS = """
#include <pcl/point_types.h>
#include <pcl_conversions/pcl_conversions.h>
#include <cstdio>
int main()
{
  pcl::PointCloud<pcl::PointXYZI> cloud;
  cloud.header.frame_id = "laser";
  cloud.header.stamp = 1700000000123456;
  for (int i = 0; i < 3; ++i) {
    pcl::PointXYZI point;
    point.x = 1.0f * i;
    point.y = 2.0f * i;
    point.z = -1.0f;
    point.intensity = 10.0f * i;
    cloud.push_back(point);
  }
  sensor_msgs::msg::PointCloud2 message;
  pcl::toROSMsg(cloud, message);
  std::printf("%s %d.%09u %u x %u\\n", message.header.frame_id.c_str(), message.header.stamp.sec,
    message.header.stamp.nanosec, message.width, message.height);
  std::printf("%s %d %d\\n", pcl::getFieldsList(message).c_str(), pcl::getFieldIndex(message, "intensity"),
    pcl::getFieldIndex(message, "rgb"));
  pcl::PointCloud<pcl::PointXYZ> places;
  pcl::fromROSMsg(message, places);
  std::printf("%zu %g %g %llu\\n", places.size(), places[2].y, places[2].z,
    static_cast<unsigned long long>(places.header.stamp));
  sensor_msgs::msg::PointCloud2 both;
  const bool same_fields = pcl::concatenatePointCloud(message, message, both);
  std::printf("%d %u\\n", same_fields, both.width);
  pcl::io::savePCDFile("cloud.pcd", message);
  sensor_msgs::msg::PointCloud2 loaded;
  pcl::io::loadPCDFile("cloud.pcd", loaded);
  std::printf("%u %s\\n", loaded.width, pcl::getFieldsList(loaded).c_str());
  pcl::PCLPointCloud2 moved;
  pcl_conversions::moveToPCL(message, moved);
  std::printf("%zu %zu\\n", message.data.size(), moved.data.size() / moved.point_step);
  pcl::PointIndices indices;
  indices.indices = {4, 5};
  pcl_msgs::msg::PointIndices told;
  pcl_conversions::fromPCL(indices, told);
  pcl::ModelCoefficients plane;
  pcl_msgs::msg::ModelCoefficients coefficients;
  coefficients.header.frame_id = "floor";
  coefficients.values = {0, 0, 1, -0.5};
  pcl_conversions::toPCL(coefficients, plane);
  std::printf("%d %s %g\\n", told.indices[1], plane.header.frame_id.c_str(), plane.values[3]);
}
"""
THINS = """
#include <pcl/filters/passthrough.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/point_types.h>
#include <pcl_ros/transforms.hpp>
#include <rclcpp/rclcpp.hpp>
#include <tf2_ros/transform_listener.h>
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
class Thins : public rclcpp::Node
{
public:
  Thins()
  : Node("thins"), buffer_(get_clock()), listener_(buffer_)
  {
    publisher_ = create_publisher<sensor_msgs::msg::PointCloud2>("thin", 10);
    subscription_ = create_subscription<sensor_msgs::msg::PointCloud2>(
      "points", 10, [this](sensor_msgs::msg::PointCloud2::ConstSharedPtr message) {thin(*message);});
  }

private:
  void thin(const sensor_msgs::msg::PointCloud2 & message)
  {
    sensor_msgs::msg::PointCloud2 in_base;
    if (!pcl_ros::transformPointCloud("base_link", message, in_base, buffer_)) {
      return;
    }
    auto cloud = std::make_shared<Cloud>();
    pcl::fromROSMsg(in_base, *cloud);
    auto low = std::make_shared<Cloud>();
    pcl::PassThrough<pcl::PointXYZ> pass;
    pass.setInputCloud(cloud);
    pass.setFilterFieldName("z");
    pass.setFilterLimits(0.0, 1.0);
    pass.filter(*low);
    Cloud thin, in_laser;
    pcl::VoxelGrid<pcl::PointXYZ> grid;
    grid.setInputCloud(low);
    grid.setLeafSize(0.5f, 0.5f, 0.5f);
    grid.filter(thin);
    pcl_ros::transformPointCloud("laser", thin, in_laser, buffer_);
    RCLCPP_INFO(get_logger(), "%zu points, %zu low, %zu left, the first at %.1f, in %s at %.1f", cloud->size(),
      low->size(), thin.size(), thin[0].x, in_laser.header.frame_id.c_str(), in_laser[0].x);
    sensor_msgs::msg::PointCloud2 result;
    pcl::toROSMsg(thin, result);
    publisher_->publish(result);
  }
  tf2_ros::Buffer buffer_;
  tf2_ros::TransformListener listener_;
  rclcpp::Publisher<sensor_msgs::msg::PointCloud2>::SharedPtr publisher_;
  rclcpp::Subscription<sensor_msgs::msg::PointCloud2>::SharedPtr subscription_;
};
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  rclcpp::spin(std::make_shared<Thins>());
  rclcpp::shutdown();
}
"""
ASKS = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session
import numpy as np, rclpy
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import PointCloud2
from sensor_msgs_py import point_cloud2
from std_msgs.msg import Header
from tf2_ros import StaticTransformBroadcaster
points = [(0.1, 0.1, 0.1), (0.12, 0.1, 0.1), (4.1, 0.1, 0.1), (0.1, 0.1, 3.0), (0.1, 0.1, -2.0)]
with (session := Session(virtual=True)).use():
    thins = session.launch(make_process(session, find("k_clouds", "thins"), (), name="thins"))
    rclpy.init()
    node = rclpy.create_node("asks")
    mount = TransformStamped(child_frame_id="laser", header=Header(frame_id="base_link"))
    mount.transform.translation.x, mount.transform.translation.z, mount.transform.rotation.w = 2.0, 0.5, 1.0
    broadcaster = StaticTransformBroadcaster(node)
    broadcaster.sendTransform(mount)
    thin = []
    node.create_subscription(PointCloud2, "thin", thin.append, 10)
    publisher = node.create_publisher(PointCloud2, "points", 10)
    while not node.count_subscribers("points"):
        rclpy.spin_once(node, timeout_sec=0.1)
    stamp = node.get_clock().now().to_msg()
    publisher.publish(point_cloud2.create_cloud_xyz32(Header(frame_id="laser", stamp=stamp), points))
    while not thin:
        rclpy.spin_once(node)
    cloud = point_cloud2.read_points_numpy(thin[0], ("x", "y", "z"))
    print(thin[0].header.frame_id, np.round(np.array(sorted(map(tuple, cloud)), float), 2).tolist())
    thins.interrupt()
    print(thins.wait(3.0), thins.output)
"""


PROGRAMS = {"src/converts.cpp": CONVERTS, "src/thins.cpp": THINS}


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    """A workspace with both programs, built."""
    if not any(Path("/usr/include").glob("pcl-*")):
        pytest.skip("needs libpcl-dev")
    folder = tmp_path_factory.mktemp("clouds")
    lay_out(folder, "k_clouds", CMAKE, PROGRAMS, ("pcl_conversions", "pcl_ros"))
    built(folder)
    return folder


def test_messages_become_clouds_and_clouds_messages(workspace):
    done = sourced(workspace, "ros2 run k_clouds converts")
    assert done.stdout.splitlines() == [
        "laser 1700000000.123456000 3 x 1",
        "x y z intensity 3 -1",
        "3 4 -1 1700000000123456",
        "1 6",
        "3 x y z intensity",
        "0 3",
        "5 floor -0.5",
    ], done.stdout + done.stderr


def test_a_node_filters_clouds_in_another_frame(workspace):
    done = scripted(workspace, ASKS)
    assert "base_link [[2.11, 0.1, 0.6], [6.1, 0.1, 0.6]]" in done.stdout, done.stdout + done.stderr
    assert "5 points, 3 low, 2 left, the first at 2.1, in laser at 0.1" in done.stdout


def test_without_it_the_command_that_brings_it_is_named(tmp_path):
    compiler_or_skip()
    lay_out(tmp_path, "k_clouds", CMAKE, PROGRAMS, ("pcl_conversions", "pcl_ros"))
    done = colcon(tmp_path, "build", "--cmake-args", "-DCMAKE_DISABLE_FIND_PACKAGE_PCL=ON")
    cure = "there is no PCL for C++ here: `sudo apt install g++ libpcl-dev` brings it"
    assert f"Skipped C++ of k_clouds: converts, thins ({cure}" in done.stdout
