"""Packages in C++ that take more than rclcpp: KDL for arms, transports of images, libraries of the system's."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>{name}</name><version>0.1.0</version><description>Tools.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
{depends}<export><build_type>ament_cmake</build_type></export></package>
"""
HEAD = """
cmake_minimum_required(VERSION 3.8)
project({name})
find_package(ament_cmake REQUIRED)
"""


def lay_out(folder: Path, name: str, cmake: str, files: dict[str, str], depends: tuple[str, ...] = ()) -> None:
    """Write a package."""
    tags = "".join(f"<depend>{dependency}</depend>" for dependency in depends)
    known = {"package.xml": MANIFEST.format(name=name, depends=tags), "CMakeLists.txt": HEAD.format(name=name) + cmake}
    for path, text in {**known, **files}.items():
        place = folder / "src" / name / path
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(text.lstrip(), encoding="utf-8")


def built(folder: Path) -> None:
    """Build the workspace."""
    compiler_or_skip()
    done = colcon(folder, "build")
    assert done.returncode == 0 and "Skipped" not in done.stdout, done.stdout + done.stderr


ARM_CMAKE = """
find_package(orocos_kdl_vendor REQUIRED)
find_package(orocos_kdl REQUIRED)
find_package(kdl_parser REQUIRED)
find_package(tf2_kdl REQUIRED)
add_executable(arm src/arm.cpp)
ament_target_dependencies(arm orocos_kdl kdl_parser tf2_kdl)
add_executable(plain src/plain.cpp)
target_include_directories(plain PRIVATE ${orocos_kdl_INCLUDE_DIRS})
target_link_libraries(plain ${orocos_kdl_LIBRARIES})
install(TARGETS arm plain DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
ARM = """
#include <iostream>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <tf2_kdl/tf2_kdl.hpp>
const char * ROBOT = R"(<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0'
  iyy='1' iyz='0' izz='1'/></inertial></link><link name='upper'><inertial><origin xyz='0 0 1' rpy='0 1.5707963 0'/>
  <mass value='2'/><inertia ixx='1' ixy='0' ixz='0' iyy='2' iyz='0' izz='3'/></inertial></link><link name='slide'/>
  <joint name='turn' type='revolute'><parent link='base'/><child link='upper'/><origin xyz='0 0 1' rpy='0 0 1.5707963'/>
  <axis xyz='1 0 0'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>
  <joint name='push' type='prismatic'><parent link='upper'/><child link='slide'/><axis xyz='0 0 1'/>
  <limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>)";
int main()
{
  KDL::Tree tree, none;
  std::cout << kdl_parser::treeFromString(ROBOT, tree) << kdl_parser::treeFromString("<robot", none) << std::endl;
  KDL::Chain chain;
  tree.getChain("base", "slide", chain);
  KDL::JntArray joints(chain.getNrOfJoints());
  joints(0) = M_PI / 2;
  joints(1) = 0.5;
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain).JntToCart(joints, frame);
  auto place = tf2::kdlToTransform(frame).transform.translation;
  std::printf("%.2f %.2f %.2f\\n", place.x, std::abs(place.y), place.z);
  const KDL::RigidBodyInertia inertia = chain.getSegment(0).getInertia();
  std::printf("%.1f %.1f %.1f\\n", inertia.getMass(), inertia.getCOG().z(), inertia.getRotationalInertia().data[0]);
  geometry_msgs::msg::TransformStamped up;
  up.header.frame_id = "map";
  up.transform.rotation.w = 1;
  up.transform.translation.z = 3;
  tf2::Stamped<KDL::Vector> point(KDL::Vector(1, 2, 3), tf2::TimePoint(), "base"), moved;
  tf2::doTransform(point, moved, up);
  auto message = tf2::toMsg(moved);
  std::cout << message.header.frame_id << message.point.z << std::endl;
  KDL::Frame back;
  tf2::fromMsg(tf2::toMsg(frame), back);
  std::cout << KDL::Equal(frame, back) << std::endl;
}
"""
PLAIN = """
#include <iostream>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/frames_io.hpp>
int main() {std::cout << KDL::Vector(1, 2, 3).Norm() * KDL::Rotation::Identity().UnitZ().z() << std::endl;}
"""


def test_arms_are_counted_with_by_the_system_s_kdl(tmp_path):
    if not os.path.isfile("/usr/include/kdl/frames.hpp"):
        pytest.skip("needs liborocos-kdl-dev")
    lay_out(tmp_path, "k_arm", ARM_CMAKE, {"src/arm.cpp": ARM, "src/plain.cpp": PLAIN}, ("kdl_parser", "tf2_kdl"))
    built(tmp_path)
    done = sourced(tmp_path, "ros2 run k_arm arm")
    assert done.stdout.splitlines() == ["10", "0.50 0.00 1.00", "2.0 1.0 5.0", "map6", "1"], done.stdout + done.stderr
    assert "The root link base has an inertia specified in the URDF, but KDL does not support" in done.stderr
    assert sourced(tmp_path, "ros2 run k_arm plain").stdout == "3.74166\n"


FIT_CMAKE = """
find_package(tf2_geometry_msgs REQUIRED)
add_executable(fits src/fits.cpp)
ament_target_dependencies(fits tf2_geometry_msgs)
install(TARGETS fits DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
FITS = """
#include <Eigen/Dense>
#include <iostream>
int main() {std::cout << Eigen::Matrix2d::Identity().inverse().trace() << std::endl;}
"""


def test_messages_of_tf2_bring_eigen_as_on_a_robot(tmp_path):
    if not os.path.isdir("/usr/include/eigen3"):
        pytest.skip("needs libeigen3-dev")
    lay_out(tmp_path, "k_fit", FIT_CMAKE, {"src/fits.cpp": FITS}, ("tf2_geometry_msgs",))
    built(tmp_path)
    assert sourced(tmp_path, "ros2 run k_fit fits").stdout == "2\n"


VENDORS_CMAKE = """
find_package(yaml_cpp_vendor REQUIRED)
find_package(yaml-cpp REQUIRED)
find_package(tinyxml2_vendor REQUIRED)
find_package(TinyXML2 REQUIRED)
add_executable(reads src/reads.cpp)
ament_target_dependencies(reads yaml_cpp_vendor TinyXML2)
target_link_libraries(reads yaml-cpp)
ament_package()
"""


def test_without_a_library_of_the_system_s_the_command_that_brings_it_is_named(tmp_path):
    compiler_or_skip()
    if os.path.isfile("/usr/include/tinyxml2.h"):
        pytest.skip("has libtinyxml2-dev")
    lay_out(tmp_path, "k_reader", VENDORS_CMAKE, {"src/reads.cpp": "int main() {}"}, ("yaml_cpp_vendor", "tinyxml2_vendor"))
    done = colcon(tmp_path, "build")
    assert done.returncode == 0
    why = "there is no tinyxml2 for C++ here: `sudo apt install libtinyxml2-dev` brings it, on Debian and Ubuntu"
    assert f"Skipped C++ of k_reader: reads ({why}; the rest is installed)" in done.stdout


YAML_CMAKE = """
find_package(yaml-cpp REQUIRED)
add_executable(direct src/reads.cpp)
target_link_libraries(direct yaml-cpp)
add_executable(by_variable src/reads.cpp)
target_include_directories(by_variable PRIVATE ${YAML_CPP_INCLUDE_DIR})
target_link_libraries(by_variable ${YAML_CPP_LIBRARIES})
add_executable(by_ament src/reads.cpp)
ament_target_dependencies(by_ament "yaml-cpp")
install(TARGETS direct by_variable by_ament DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
READS_YAML = """
#include <iostream>
#include <yaml-cpp/yaml.h>
int main() {std::cout << YAML::Load("speed: 2.5")["speed"].as<double>() << std::endl;}
"""


def test_yaml_cpp_is_the_system_s_or_ours(tmp_path):
    compiler_or_skip()
    lay_out(tmp_path, "k_settings", YAML_CMAKE, {"src/reads.cpp": READS_YAML}, ())
    built(tmp_path)
    ran = [f"ros2 run k_settings {name}" for name in ("direct", "by_variable", "by_ament")]
    assert sourced(tmp_path, "; ".join(ran)).stdout == "2.5\n" * 3


CHECKED_CMAKE = """
find_package(generate_parameter_library REQUIRED)
generate_parameter_library(speeds src/speeds.yaml include/checks.hpp)
add_executable(drives src/drives.cpp)
target_link_libraries(drives speeds)
ament_package()
"""


def test_a_header_of_checks_that_formats_asks_for_fmt(tmp_path):
    compiler_or_skip()
    if os.path.isdir("/usr/include/fmt"):
        pytest.skip("has libfmt-dev")
    yaml, checks = "speeds: {top: {type: double}}", "#include <fmt/core.h>"
    files = {"src/drives.cpp": "int main() {}", "src/speeds.yaml": yaml, "include/checks.hpp": checks}
    lay_out(tmp_path, "k_drives", CHECKED_CMAKE, files, ("generate_parameter_library",))
    done = colcon(tmp_path, "build")
    assert "there is no fmt for C++ here: `sudo apt install libfmt-dev` brings it" in done.stdout, done.stdout + done.stderr


TINY_CMAKE = """
find_package(image_transport REQUIRED)
find_package(pluginlib REQUIRED)
find_package(sensor_msgs REQUIRED)
add_library(${PROJECT_NAME} SHARED src/tiny.cpp)
ament_target_dependencies(${PROJECT_NAME} image_transport pluginlib sensor_msgs)
pluginlib_export_plugin_description_file(image_transport plugins.xml)
add_executable(both src/both.cpp)
ament_target_dependencies(both image_transport)
install(TARGETS ${PROJECT_NAME} ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
install(TARGETS both DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
PLUGINS = """<library path="k_tiny">
  <class name="image_transport/tiny_pub" type="k_tiny::TinyPublisher" base_class_type="image_transport::PublisherPlugin">
    <description>Small.</description></class>
  <class name="image_transport/tiny_sub" type="k_tiny::TinySubscriber" base_class_type="image_transport::SubscriberPlugin">
    <description>Small.</description></class>
</library>
"""
TINY = """
#include <image_transport/simple_publisher_plugin.hpp>
#include <image_transport/simple_subscriber_plugin.hpp>
#include <pluginlib/class_list_macros.hpp>
#include <sensor_msgs/msg/compressed_image.hpp>
namespace k_tiny
{
using sensor_msgs::msg::CompressedImage;
class TinyPublisher : public image_transport::SimplePublisherPlugin<CompressedImage>
{
public:
  std::string getTransportName() const override {return "tiny";}
protected:
  void publish(const sensor_msgs::msg::Image & message, const PublishFn & publish_fn) const override
  {
    CompressedImage small;
    small.header = message.header;
    small.format = "tiny";
    small.data = {message.data.front()};
    publish_fn(small);
  }
};
class TinySubscriber : public image_transport::SimpleSubscriberPlugin<CompressedImage>
{
public:
  std::string getTransportName() const override {return "tiny";}
protected:
  void internalCallback(const CompressedImage::ConstSharedPtr & message, const Callback & user_cb) override
  {
    auto image = std::make_shared<sensor_msgs::msg::Image>();
    image->header = message->header;
    image->data.assign(4, message->data.front());
    user_cb(image);
  }
};
}
PLUGINLIB_EXPORT_CLASS(k_tiny::TinyPublisher, image_transport::PublisherPlugin)
PLUGINLIB_EXPORT_CLASS(k_tiny::TinySubscriber, image_transport::SubscriberPlugin)
"""
BOTH = """
#include <image_transport/image_transport.hpp>
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("both");
  image_transport::ImageTransport transport(node);
  for (auto & name : transport.getLoadableTransports()) {std::cout << name << std::endl;}
  auto publisher = transport.advertise("image", 1);
  image_transport::TransportHints hints(node.get(), "tiny");
  int heard = 0;
  auto subscriber = transport.subscribe("image", 1, [&](const sensor_msgs::msg::Image::ConstSharedPtr & image) {
      std::cout << image->data.size() << " " << int(image->data[3]) << std::endl;
      if (++heard == 2) {rclcpp::shutdown();}
    }, nullptr, &hints);
  std::cout << subscriber.getTransport() << " " << subscriber.getTopic() << " ";
  std::cout << publisher.getNumSubscribers() << std::endl;
  auto timer = node->create_wall_timer(std::chrono::milliseconds(100), [&] {
      sensor_msgs::msg::Image image;
      image.data = {7, 8, 9};
      publisher.publish(image);
    });
  rclcpp::spin(node);
}
"""


def test_a_transport_of_images_that_a_package_describes_is_loaded(tmp_path):
    files = {"plugins.xml": PLUGINS, "src/tiny.cpp": TINY, "src/both.cpp": BOTH}
    lay_out(tmp_path, "k_tiny", TINY_CMAKE, files, ("image_transport", "pluginlib", "sensor_msgs"))
    built(tmp_path)
    said = sourced(tmp_path, "ros2 run k_tiny both").stdout
    assert said.splitlines() == ["image_transport/raw", "image_transport/tiny", "tiny /image/tiny 1", "4 7", "4 7"]
