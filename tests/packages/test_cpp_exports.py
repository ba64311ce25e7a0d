"""What a package of C++ gives to those that find it: targets, a version, files of its own; and how its tests are named."""

from __future__ import annotations

import os
import re

import pytest

from coursekit.cpp.exported import EXPORTED, exported_by
from coursekit.cpp.runtime import PACKAGES
from coursekit.interfaces.find import UNDERLAY
from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, sourced

MANIFEST = """<package format="3"><name>{name}</name><version>1.4.2</version><description>Means.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake_ros</buildtool_depend>
{depends}<export><build_type>ament_cmake</build_type></export></package>"""
LIBRARY = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.5)
project(means LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 14)
add_compile_options(-Wall -Wextra -Wpedantic -Werror)
find_package(ament_cmake_ros REQUIRED)
find_package(rclcpp 16.0 REQUIRED)
find_package(OpenCV 4 REQUIRED)
add_library(means src/mean.cpp)
target_include_directories(means PUBLIC
  "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include>" "$<INSTALL_INTERFACE:include/means>")
target_link_libraries(means PUBLIC rclcpp::rclcpp rcutils::rcutils ${rcl_interfaces_TARGETS})
install(DIRECTORY include/ DESTINATION include/means)
install(TARGETS means EXPORT export_means ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  ament_add_ros_isolated_gtest(test_mean test/test_mean.cpp TIMEOUT 60)
  target_link_libraries(test_mean means)
  find_package(ament_cmake_pytest REQUIRED)
  find_package(rmw_implementation_cmake REQUIRED)
  get_available_rmw_implementations(middlewares)
  foreach(middleware ${middlewares})
    find_package(${middleware} REQUIRED)
  endforeach()
  macro(tests)
    foreach(what name)
      configure_file(test/test_text.py.in test_${what}${target_suffix}.py @ONLY)
      ament_add_pytest_test(test_${what} "${CMAKE_CURRENT_BINARY_DIR}/test_${what}${target_suffix}.py")
      set_property(TEST test_${what} APPEND PROPERTY DEPENDS means)
    endforeach()
  endmacro()
  call_for_each_rmw_implementation(tests)
endif()
ament_export_targets(export_means HAS_LIBRARY_TARGET)
ament_export_dependencies(rclcpp)
ament_package(CONFIG_EXTRAS "means-extras.cmake.in")
""",
    "means-extras.cmake.in": 'function(of_@PROJECT_NAME@)\n  message(STATUS "extras of @PROJECT_NAME@")\nendfunction()\n',
    "include/means/mean.hpp": """#pragma once
#include <vector>
namespace means {double mean(const std::vector<double> & all);}
""",
    "src/mean.cpp": """#include "means/mean.hpp"
#include <numeric>
#include "rcl_interfaces/msg/parameter.hpp"
#include "rclcpp/rclcpp.hpp"
double means::mean(const std::vector<double> & all)
{
  return std::accumulate(all.begin(), all.end(), 0.0) / static_cast<double>(all.size());
}
""",
    "test/test_mean.cpp": """#include <gtest/gtest.h>
#include "means/mean.hpp"
TEST(mean, of_two) {EXPECT_DOUBLE_EQ(means::mean({1, 2}), 1.5);}
""",
    "test/test_text.py.in": "def test_name():\n    assert '@PROJECT_NAME@' == 'means'\n",
}
USER = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.8)
project(asker)
find_package(ament_cmake REQUIRED)
find_package(means 1.4 REQUIRED)
find_package(means 2.0 QUIET)
if(means_FOUND)
  message(FATAL_ERROR "1.4.2 is not 2.0")
endif()
find_package(means 1.4 REQUIRED)
of_means()
add_executable(asker src/asker.cpp)
ament_target_dependencies(asker means)
install(TARGETS asker DESTINATION lib/${PROJECT_NAME})
ament_package()
""",
    "src/asker.cpp": """#include <cstdio>
#include "means/mean.hpp"
int main() {std::printf("%.1f\\n", means::mean({1, 4}));}
""",
}


@pytest.fixture
def workspace(tmp_path):
    compiler_or_skip()
    for name, files, depends in (("means", LIBRARY, "<depend>rclcpp</depend>"), ("asker", USER, "<depend>means</depend>")):
        for path, text in {**files, "package.xml": MANIFEST.format(name=name, depends=depends)}.items():
            file = tmp_path / "src" / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
    return tmp_path


@pytest.mark.slow
@pytest.mark.timeout(300)
@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_a_library_is_found_with_its_version_its_files_and_what_it_needs(workspace):
    built = colcon(workspace, "build", "--event-handlers", "console_direct+")
    assert built.returncode == 0, built.stdout + built.stderr
    assert "-- extras of means\n" in built.stdout
    assert sourced(workspace, "ros2 run asker asker").stdout == "2.5\n"
    tested = colcon(workspace, "test", "--packages-select", "means")
    assert tested.returncode == 0, tested.stdout + tested.stderr
    summary = sourced(workspace, "colcon test-result").stdout
    assert re.search(r"^Summary: 4 tests, 0 errors, 0 failures", summary, re.M), summary


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_what_cmake_remembers_of_another_runtime_is_forgotten(workspace):
    assert colcon(workspace, "build", "--packages-select", "means").returncode == 0
    cache = workspace / "build" / "means" / "CMakeCache.txt"
    other = re.sub(r"/cpp/[0-9a-f]{16}/share", "/cpp/0123456789abcdef/share", cache.read_text())
    cache.write_text(other)
    assert colcon(workspace, "build", "--packages-select", "means").returncode == 0
    assert "0123456789abcdef" not in cache.read_text()


def test_packages_are_found_with_others_that_are_there():
    share = UNDERLAY / "share"
    there = {*PACKAGES, *(path.parent.name for path in share.glob("*/package.xml"))}
    for name in there:
        assert set(exported_by(name, share)) <= there, name
    assert set(EXPORTED) <= there
    assert exported_by("nav2_msgs", share) == sorted(exported_by("nav2_msgs", share)) != []


OWN = {
    "rcpputils": {
        "CMakeLists.txt": """cmake_minimum_required(VERSION 3.8)
project(rcpputils)
find_package(ament_cmake REQUIRED)
find_package(rcutils REQUIRED)
add_library(rcpputils src/own.cpp)
target_include_directories(rcpputils PUBLIC include)
ament_target_dependencies(rcpputils rcutils)
install(TARGETS rcpputils DESTINATION lib)
ament_export_libraries(rcpputils)
ament_package()
""",
        "include/rcpputils/filesystem_helper.hpp": "namespace rcpputils {namespace fs {class path; int current_path();}}\n",
        "src/own.cpp": """#include "rcpputils/filesystem_helper.hpp"
#include "rcutils/filesystem.h"
namespace rcpputils {namespace fs {int current_path() {return rcutils_exists("/") ? 7 : 0;}}}
""",
    },
    "asker": {
        "CMakeLists.txt": """cmake_minimum_required(VERSION 3.8)
project(asker)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
find_package(rcpputils REQUIRED)
add_executable(asker src/asker.cpp src/answer.cpp)
ament_target_dependencies(asker rclcpp rcpputils)
install(TARGETS asker DESTINATION lib/${PROJECT_NAME})
ament_package()
""",
        "src/asker.cpp": """#include <cstdio>
#include "rclcpp/rclcpp.hpp"
int answer();
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("asker");
  std::printf("%s %d\\n", node->get_name(), answer());
}
""",
        "src/answer.cpp": """namespace rcpputils {namespace fs {int current_path();}}
int answer() {return rcpputils::fs::current_path();}
""",
    },
}


@pytest.mark.slow
def test_a_workspace_s_own_copy_of_a_package_is_taken_before_the_runtime_s(tmp_path):
    compiler_or_skip()
    for name, files in OWN.items():
        depends = "<depend>rcpputils</depend>" if name == "asker" else ""
        for path, text in {**files, "package.xml": MANIFEST.format(name=name, depends=depends)}.items():
            file = tmp_path / "src" / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 0, built.stderr
    assert sourced(tmp_path, "ros2 run asker asker").stdout == "asker 7\n"


STRICT = {
    "CMakeLists.txt": """cmake_minimum_required(VERSION 3.5)
project(strict)
set(CMAKE_CXX_STANDARD 14)
add_link_options("-Wl,-z,relro,-z,now,-z,defs")
set(Nowhere_ROOT /usr)  # newer versions of CMake warn of it in a project that asks for an old one
find_package(Nowhere QUIET)
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
add_library(strict SHARED src/strict.cpp)
ament_target_dependencies(strict rclcpp rclcpp_components)
rclcpp_components_register_node(strict PLUGIN "Strict" EXECUTABLE strict_node)
install(TARGETS strict ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
ament_environment_hooks(${ament_cmake_package_templates_ENVIRONMENT_HOOK_LIBRARY_PATH})
ament_package()
""",
    "src/strict.cpp": """#include "rclcpp_components/register_node_macro.hpp"
struct Strict : rclcpp::Node
{
  explicit Strict(const rclcpp::NodeOptions & options)
  : Node("strict", options)
  {
    RCLCPP_INFO(get_logger(), "made");
    rclcpp::shutdown();
  }
};
RCLCPP_COMPONENTS_REGISTER_NODE(Strict)
""",
}


@pytest.mark.slow
@pytest.mark.timeout(300)
def test_rclcpp_brings_ament_cmake_and_libraries_may_ask_for_all_their_names(tmp_path):
    compiler_or_skip()
    folder = tmp_path / "src" / "strict"
    for name, text in {**STRICT, "package.xml": MANIFEST.format(name="strict", depends="")}.items():
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    built = colcon(tmp_path, "build")
    assert built.returncode == 0 and "stderr" not in built.stdout, built.stdout + built.stderr
    assert (tmp_path / "install/strict/lib/libstrict.so").is_file()
    ran = sourced(tmp_path, "ros2 run strict strict_node")
    assert "[strict]: made" in ran.stdout + ran.stderr
