"""rosidl_cmake's functions in a package with C++, and what has to come before a package's end."""

from __future__ import annotations

import os

import pytest

from tests.needs import compiler_or_skip, posix
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
MANIFEST = """<package format="3"><name>{name}</name><version>1.0.0</version><description>d</description>
<maintainer email="a@example.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>{depend}</depend><export><build_type>ament_cmake</build_type></export></package>"""
LISTS = """cmake_minimum_required(VERSION 3.8)
project(lists NONE)
find_package(ament_cmake_core REQUIRED)
install(DIRECTORY msg DESTINATION share/lists)
set(${PROJECT_NAME}_CONFIG_EXTRAS_POST later.cmake)
ament_package(CONFIG_EXTRAS lists-extras.cmake.in)
"""
READER = """cmake_minimum_required(VERSION 3.8)
project(reader)
find_package(ament_cmake REQUIRED)
find_package(rosidl_cmake REQUIRED)
find_package(rosidl_generator_cpp REQUIRED)
find_package(rosidl_typesupport_introspection_cpp REQUIRED)
find_package(lists REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "${lists_DIR}/..:${lists_FILE}" SKIP_INSTALL)
rosidl_get_typesupport_target(generated ${PROJECT_NAME} "rosidl_generator_cpp")
rosidl_get_typesupport_target(looks ${PROJECT_NAME} "rosidl_typesupport_introspection_cpp")
rosidl_get_typesupport_target(unknown ${PROJECT_NAME} "of_mine")
message(STATUS "SAID ${generated} ${looks} ${unknown} ${lists_LATER}")
add_executable(reads reads.cpp)
target_link_libraries(reads ${generated} ${looks} rosidl_typesupport_introspection_cpp::rosidl_typesupport_introspection_cpp)
install(TARGETS reads DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
READS = """#include <iostream>
#include "reader/msg/length.hpp"
#include "rosidl_typesupport_introspection_cpp/message_introspection.hpp"
int main()
{
  namespace facts = rosidl_typesupport_introspection_cpp;
  auto members = static_cast<const facts::MessageMembers *>(
    facts::get_message_type_support_handle<reader::msg::Length>()->data);
  std::cout << rosidl_generator_traits::name<reader::msg::Length>() << " " << members->members_[0].name_ << std::endl;
}
"""
IN_C = """cmake_minimum_required(VERSION 3.8)
project(in_c{languages})
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(std_msgs REQUIRED)
rosidl_generate_interfaces(${{PROJECT_NAME}} "msg/Named.msg" DEPENDENCIES std_msgs)
rosidl_get_typesupport_target(generated ${{PROJECT_NAME}} "rosidl_generator_c")
add_executable(names names.c)
target_link_libraries(names ${{generated}} std_msgs::std_msgs__rosidl_generator_c)
install(TARGETS names DESTINATION lib/${{PROJECT_NAME}})
ament_package()
"""
NAMED = """std_msgs/Header header
string<=9 name "nobody"
"""
NAMES = """#include <stdio.h>
#include "in_c/msg/named.h"
#include "std_msgs/msg/string.h"
int main(void)
{
  in_c__msg__Named * named = in_c__msg__Named__create();
  std_msgs__msg__String text;
  if (!named || !std_msgs__msg__String__init(&text) || !rosidl_runtime_c__String__copy(&named->name, &text.data)) {
    return 1;
  }
  printf("%s %d\\n", text.data.data, (int)in_c__msg__Named__name__MAX_STRING_SIZE);
  std_msgs__msg__String__fini(&text);
  in_c__msg__Named__destroy(named);
  return 0;
}
"""
LATE = """cmake_minimum_required(VERSION 3.8)
project(late)
find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
add_executable(late late.cpp)
ament_package()
"""


def package(workspace, name, files, depend="std_msgs"):
    """A package in a workspace, of files by their names."""
    for file, text in {"package.xml": MANIFEST.format(name=name, depend=depend), **files}.items():
        path = workspace / "src" / name / file
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)


@posix("bash sources the workspace")
def test_a_package_without_a_language_gives_files_that_another_generates_from(tmp_path):
    compiler_or_skip()
    extras = {"lists-extras.cmake.in": "set(@PROJECT_NAME@_FILE msg/Length.msg)\n", "later.cmake": "set(lists_LATER yes)\n"}
    package(tmp_path, "lists", {"CMakeLists.txt": LISTS, "msg/Length.msg": "float32 metres\n", **extras})
    package(tmp_path, "reader", {"CMakeLists.txt": READER, "reads.cpp": READS}, depend="lists")
    built = colcon(tmp_path, "build", "--event-handlers", "console_direct+")
    assert built.returncode == 0, built.stderr
    targets = "reader__rosidl_generator_cpp reader__rosidl_typesupport_introspection_cpp reader__of_mine-NOTFOUND"
    assert f"-- SAID {targets} yes\n" in built.stdout
    assert sourced(tmp_path, "ros2 run reader reads").stdout == "reader/msg/Length metres\n"
    assert not (tmp_path / "install" / "reader" / "include").exists()


@pytest.mark.parametrize("function", ["ament_export_libraries", "ament_export_targets", "rosidl_generate_interfaces"])
def test_what_comes_after_a_package_s_end_is_refused(tmp_path, function):
    compiler_or_skip()
    package(tmp_path, "late", {"CMakeLists.txt": f"{LATE}{function}(late more)\n", "late.cpp": "int main() {}"})
    built = colcon(tmp_path, "build")
    assert built.returncode == 1 and f"{function}() must be called before ament_package()" in built.stderr


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ("late msg/Nope.msg", "the passed file 'msg/Nope.msg' doesn't exist relative to the"),
        ("late ${CMAKE_CURRENT_SOURCE_DIR}/late.cpp", "must be represented as an absolute base path"),
        ("late late.cpp DEPENDENCIES nav_msgs", "the passed dependency 'nav_msgs' has not been found before"),
        ("late", "called without any interface files"),
    ],
)
def test_what_is_passed_for_interfaces_is_refused_as_rosidl_refuses_it(tmp_path, written, said):
    compiler_or_skip()
    text = LATE.replace("ament_package()", f"rosidl_generate_interfaces({written})\nament_package()")
    package(tmp_path, "late", {"CMakeLists.txt": text, "late.cpp": "int main() {}"})
    built = colcon(tmp_path, "build")
    assert built.returncode == 1 and said in " ".join(built.stderr.split())


TESTED = """cmake_minimum_required(VERSION 3.8)
project(tested)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rosidl_default_generators REQUIRED)
find_package(ament_cmake_gtest REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} msg/Length.msg SKIP_INSTALL)
ament_add_gtest(test_length test_length.cpp)
ament_target_dependencies(test_length rclcpp)
rosidl_get_typesupport_target(generated ${PROJECT_NAME} rosidl_typesupport_cpp)
target_link_libraries(test_length ${generated})
ament_package()
"""
TEST = """#include <gtest/gtest.h>
#include "rclcpp/rclcpp.hpp"
#include "tested/msg/length.hpp"
TEST(Length, comes)
{
  rclcpp::init(0, nullptr);
  auto node = std::make_shared<rclcpp::Node>("node");
  float metres = 0;
  auto hear = [&](const tested::msg::Length & message) {metres = message.metres;};
  auto subscription = node->create_subscription<tested::msg::Length>("length", 10, hear);
  tested::msg::Length sent;
  sent.metres = 2.5;
  node->create_publisher<tested::msg::Length>("length", 10)->publish(sent);
  rclcpp::spin_some(node);
  EXPECT_EQ(metres, 2.5f);
  rclcpp::shutdown();
}
"""


@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_interfaces_that_are_not_installed_serve_the_package_s_own_tests(tmp_path):
    compiler_or_skip()
    files = {"CMakeLists.txt": TESTED, "msg/Length.msg": "float32 metres\n", "test_length.cpp": TEST}
    package(tmp_path, "tested", files, depend="rclcpp")
    assert colcon(tmp_path, "build").returncode == 0
    tested = colcon(tmp_path, "test", "--event-handlers", "console_direct+")
    assert colcon(tmp_path, "test-result").stdout == "Summary: 2 tests, 0 errors, 0 failures, 0 skipped\n", tested.stdout
    assert not (tmp_path / "install" / "tested" / "share" / "tested" / "msg").exists()


@posix("bash sources the workspace")
@pytest.mark.parametrize("languages", ["", " C"])
def test_a_program_in_c_has_messages_in_c(tmp_path, languages):
    compiler_or_skip()
    files = {"CMakeLists.txt": IN_C.format(languages=languages), "msg/Named.msg": NAMED, "names.c": NAMES}
    package(tmp_path, "in_c", files)
    manifest = tmp_path / "src" / "in_c" / "package.xml"
    group = "<member_of_group>rosidl_interface_packages</member_of_group><export>"
    manifest.write_text(manifest.read_text().replace("<export>", group))
    built = colcon(tmp_path, "build")
    assert built.returncode == 0, built.stderr
    assert sourced(tmp_path, "ros2 run in_c names").stdout == "nobody 9\n"
