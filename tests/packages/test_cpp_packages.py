"""Single packages in C++, as `ros2 pkg create` makes them and as their authors break them."""

from __future__ import annotations

import os
import re
import shutil
import subprocess

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import ENV, SOURCES, colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]


@pytest.fixture(autouse=True)
def compiler():
    """These need one."""
    compiler_or_skip()


def created(tmp_path, name, words=""):
    """A package that `ros2 pkg create` has made."""
    (tmp_path / "src").mkdir()
    line = f"ros2 pkg create --build-type ament_cmake --destination-directory src {name} {words}"
    assert subprocess.run(["bash", "-c", line], cwd=tmp_path, env=ENV, capture_output=True).returncode == 0
    return tmp_path / "src" / name


def copied(tmp_path, package):
    """A package of the workspace that test_cpp_workspace builds."""
    shutil.copytree(SOURCES / package, tmp_path / "src" / package)
    return tmp_path / "src" / package


def test_a_package_that_ros2_pkg_creates_builds_and_runs(tmp_path):
    created(tmp_path, "first_steps", "--node-name hello --dependencies rclcpp")
    assert colcon(tmp_path, "build").returncode == 0
    assert sourced(tmp_path, "ros2 run first_steps hello").stdout == "hello world first_steps package\n"


AUTO = """cmake_minimum_required(VERSION 3.8)
project(automatic)
find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()
file(GLOB programs src/*.cpp)
foreach(path ${programs})
  get_filename_component(name ${path} NAME_WE)
  ament_auto_add_executable(${name} ${path})
endforeach()
ament_auto_package()
"""


def test_a_dependency_that_comes_into_package_xml_is_found_by_the_next_build(tmp_path):
    package = created(tmp_path, "automatic")
    manifest = (package / "package.xml").read_text().replace("ament_cmake</buildtool", "ament_cmake_auto</buildtool")
    (package / "package.xml").write_text(manifest)
    (package / "CMakeLists.txt").write_text(AUTO)
    assert colcon(tmp_path, "build").returncode == 0
    headers = "#include <std_msgs/msg/string.hpp>\n#include <cstdio>\n"
    main = "int main() {std::puts(std_msgs::msg::String().data.c_str());}\n"
    (package / "src" / "late.cpp").write_text(headers + main)
    (package / "package.xml").write_text(manifest.replace("  <export>", "  <depend>std_msgs</depend>\n  <export>"))
    done = colcon(tmp_path, "build")
    assert done.returncode == 0, done.stderr
    assert sourced(tmp_path, "ros2 run automatic late").stdout == "\n"


FIRST_TEST = """#include <gtest/gtest.h>
TEST(first, sum) {ASSERT_EQ(4, 2 + 2);}
int main(int argc, char ** argv) {testing::InitGoogleTest(&argc, argv); return RUN_ALL_TESTS();}
"""


@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_a_package_of_nothing_but_tests_in_cpp_has_them_run(tmp_path):
    package = created(tmp_path, "only_tests")
    (package / "test").mkdir()
    (package / "test" / "first.cpp").write_text(FIRST_TEST, encoding="utf-8")
    tests = "find_package(ament_cmake_gtest REQUIRED)\n  ament_add_gtest(only_first test/first.cpp)\n"
    rules = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    rules = rules.replace("ament_package()", f"if(BUILD_TESTING)\n  {tests}endif()\nament_package()")
    (package / "CMakeLists.txt").write_text(rules, encoding="utf-8")
    assert colcon(tmp_path, "build").returncode == 0
    tested = colcon(tmp_path, "test")
    left_out = [line for line in tested.stdout.splitlines() if line.startswith("Skipped")]
    assert left_out == ["Skipped tests of only_tests: cppcheck, lint_cmake, uncrustify, xmllint"], tested.stdout
    assert colcon(tmp_path, "test-result").stdout == "Summary: 2 tests, 0 errors, 0 failures, 0 skipped\n"


KEEPER = """
#include "example_interfaces/msg/int32.hpp"
#include "rclcpp/rclcpp.hpp"
#include "rosbag2_cpp/writer.hpp"
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("keeper");
  rosbag2_cpp::Writer bag;
  bag.open("kept");
  auto heard = [&](std::shared_ptr<rclcpp::SerializedMessage> message) {
      bag.write(message, "count", "example_interfaces/msg/Int32", node->now());
    };
  auto subscription = node->create_subscription<example_interfaces::msg::Int32>("count", 10, heard);
  rclcpp::spin(node);
}
"""


def test_a_package_that_names_rosbag2_cpp_records_what_is_published(tmp_path):
    needs = "rclcpp rosbag2_cpp example_interfaces"
    package = created(tmp_path, "k_bags", f"--dependencies {needs}")
    (package / "src" / "keeper.cpp").write_text(KEEPER, encoding="utf-8")
    rules = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    own = f"add_executable(keeper src/keeper.cpp)\nament_target_dependencies(keeper {needs})\n"
    own += "install(TARGETS keeper DESTINATION lib/${PROJECT_NAME})\n"
    (package / "CMakeLists.txt").write_text(rules.replace("ament_package()", f"{own}ament_package()"), encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 0 and "skip" not in built.stdout + built.stderr, built.stdout + built.stderr
    publish = "ros2 topic pub -r 2 /count example_interfaces/msg/Int32 '{data: 5}'"
    (tmp_path / "both.launch.py").write_text(
        "from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n"
        "from launch_ros.actions import Node\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([Node(package='k_bags', executable='keeper'),\n"
        f"        ExecuteProcess(cmd=[{publish!r}], shell=True)])\n",
        encoding="utf-8",
    )
    said = sourced(tmp_path, "COURSEKIT_STOP_AFTER=4 ros2 launch both.launch.py && ros2 bag info kept")
    assert "Topic: count | Type: example_interfaces/msg/Int32 | Count: " in said.stdout, said.stdout + said.stderr
    assert "Count: 0" not in said.stdout


HELPERS = """
#include "camera_info_manager/camera_info_manager.hpp"
#include "diagnostic_updater/publisher.hpp"
#include "image_geometry/pinhole_camera_model.h"
#include "interactive_markers/menu_handler.hpp"
#include "message_filters/time_sequencer.h"
#include "urdf/model.h"
int main()
{
  urdf::Model model;
  return model.initString("<robot name='ball'><link name='base_link'/></robot>") && model.getRoot() ? 0 : 1;
}
"""


def test_packages_that_robots_nodes_are_made_of_are_found(tmp_path):
    needs = "rclcpp camera_info_manager diagnostic_updater image_geometry interactive_markers message_filters urdf"
    package = created(tmp_path, "k_helpers", f"--dependencies {needs}")
    (package / "src" / "helped.cpp").write_text(HELPERS, encoding="utf-8")
    rules = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    own = f"add_executable(helped src/helped.cpp)\nament_target_dependencies(helped {needs})\n"
    own += "install(TARGETS helped DESTINATION lib/${PROJECT_NAME})\n"
    (package / "CMakeLists.txt").write_text(rules.replace("ament_package()", f"{own}ament_package()"), encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 0 and "skip" not in built.stdout + built.stderr, built.stdout + built.stderr
    assert sourced(tmp_path, "ros2 run k_helpers helped && echo good").stdout == "good\n"


def test_a_mistake_is_shown_by_the_compiler_with_a_hint(tmp_path):
    package = copied(tmp_path, "k_geometry")
    (package / "CMakeLists.txt").write_text(
        (package / "CMakeLists.txt").read_text().replace("ament_package()", "add_executable(near near.cpp)\nament_package()")
    )
    (package / "near.cpp").write_text("#include <iostream>\nint main()\n{\n  std::cout << 1\n}\n")
    built = colcon(tmp_path, "build")
    assert built.returncode == 1
    assert f"{package / 'near.cpp'}:4:" in built.stderr and re.search("error: expected .;", built.stderr)
    assert "hint: near.cpp:4: a statement ends with ;" in built.stderr
    assert "g++ " not in built.stderr and "ninja" not in built.stderr


def test_a_package_that_needs_what_only_a_robot_has_keeps_its_files(tmp_path):
    package = copied(tmp_path, "k_auto")
    manifest = package / "package.xml"
    manifest.write_text(manifest.read_text().replace("<depend>k_survey</depend>", "<depend>robot_driver_sdk</depend>"))
    (package / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(k_auto)\nfind_package(ament_cmake REQUIRED)\n"
        "find_package(robot_driver_sdk REQUIRED)\nadd_executable(asker src/asker.cpp)\n"
        "install(TARGETS asker DESTINATION lib/${PROJECT_NAME})\n"
        "install(FILES package.xml DESTINATION share/${PROJECT_NAME}/kept)\nament_package()\n"
    )
    built = colcon(tmp_path, "build")
    assert built.returncode == 0, built.stderr
    assert "Skipped C++ of k_auto: asker (C++ has no robot_driver_sdk here; the rest is installed)" in built.stdout
    assert (tmp_path / "install/k_auto/share/k_auto/kept/package.xml").is_file()


def test_a_package_whose_name_is_misspelled_is_told(tmp_path):
    package = copied(tmp_path, "k_geometry")
    text = (package / "CMakeLists.txt").read_text()
    (package / "CMakeLists.txt").write_text(text.replace("find_package(geometry_msgs", "find_package(geometry_mgs"))
    built = colcon(tmp_path, "build")
    assert built.returncode == 1
    assert 'By not providing "Findgeometry_mgs.cmake"' in built.stderr
    assert "hint: CMakeLists.txt:5: there is no package geometry_mgs" in built.stderr


def test_a_mistake_in_a_package_that_coursekit_has_programs_for_is_its_author_s(tmp_path):
    package = tmp_path / "src" / "demo_nodes_cpp"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        '<?xml version="1.0"?>\n<package format="3"><name>demo_nodes_cpp</name><version>1.0.0</version>'
        "<description>d</description>"
        '<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>'
        "<depend>rclcpp</depend><export><build_type>ament_cmake</build_type></export></package>\n",
        encoding="utf-8",
    )
    (package / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(demo_nodes_cpp)\nfind_package(ament_cmake REQUIRED)\n"
        "find_package(rclcpp REQUIRED)\nadd_executable(talker talker.cpp)\nament_target_dependencies(talker rclcpp)\n"
        "install(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package()\n",
        encoding="utf-8",
    )
    (package / "talker.cpp").write_text("int main() {return 0}\n", encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 1, built.stdout
    assert "talker.cpp:1:" in built.stderr and "expected" in built.stderr
