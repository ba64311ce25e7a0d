"""generate_parameter_library(): a YAML file of parameters becomes a struct and a listener of a C++ program."""

from __future__ import annotations

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(400)]
MANIFEST = """<?xml version="1.0"?>
<package format="3"><name>k_arm</name><version>0.1.0</version><description>An arm.</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license><buildtool_depend>ament_cmake</buildtool_depend>
<depend>generate_parameter_library</depend><export><build_type>ament_cmake</build_type></export></package>
"""
CMAKE = """
cmake_minimum_required(VERSION 3.16)
project(k_arm)
set(DEPENDENCIES rclcpp generate_parameter_library)
find_package(ament_cmake REQUIRED)
foreach(dependency IN ITEMS ${DEPENDENCIES})
  find_package(${dependency} REQUIRED)
endforeach()
generate_parameter_library(arm_parameters src/arm.yaml include/k_arm/arm_checks.hpp)
add_library(arm_library SHARED src/read.cpp)
target_link_libraries(arm_library PUBLIC arm_parameters rclcpp::rclcpp)
add_executable(arm src/arm.cpp)
target_link_libraries(arm PRIVATE arm_library)
if(BUILD_TESTING)
  find_package(ament_cmake_gtest REQUIRED)
  add_rostest_with_parameters_gtest(test_arm test/test_arm.cpp ${CMAKE_CURRENT_SOURCE_DIR}/test/arm.yaml)
  target_link_libraries(test_arm arm_parameters)
endif()
install(TARGETS arm DESTINATION lib/${PROJECT_NAME})
install(TARGETS arm_library arm_parameters EXPORT export_k_arm
  RUNTIME DESTINATION bin ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
ament_export_targets(export_k_arm HAS_LIBRARY_TARGET)
ament_export_dependencies(${DEPENDENCIES})
ament_package()
"""
YAML = """
arm_driver:
  rate:
    {type: double, default_value: 50.0, description: "How often, in \\"Hz\\"", validation: {gt<>: [0.0], lt_eq<>: [1000.0]}}
  joints: {type: string_array, validation: {unique<>: null, not_empty<>: []}}
  mode: {type: string, default_value: slow, read_only: true, validation: {one_of<>: [["slow", "fast"]]}}
  count: {type: int, default_value: 3, validation: {bounds<>: [1, 9], "arm_checks::is_odd": null}}
  tag: {type: string_fixed_8, default_value: "tag"}
  ranks: {type: int_array_fixed_4, default_value: [1, 2]}
  gains:
    __map_joints:
      p: {type: double, default_value: 2.5, validation: {gt_eq<>: [0.5]}}
      limit:
        high: {type: int, default_value: 7}
  filter: {type: none, description: "read by another library"}
"""
CHECKS = """
#pragma once
#include "rclcpp/parameter.hpp"
#include "tl_expected/expected.hpp"
namespace arm_checks
{
inline tl::expected<void, std::string> is_odd(const rclcpp::Parameter & parameter)
{
  if (parameter.as_int() % 2 == 0) {
    return tl::make_unexpected(parameter.get_name() + " is even");
  }
  return {};
}
}
"""
READ = """
#include "arm_parameters.hpp"
double sum_of_gains(const arm_driver::Params & params)
{
  double sum = 0;
  for (const auto & [name, gains] : params.gains.joints_map) {sum += gains.p + gains.limit.high;}
  return sum;
}
"""
PROGRAM = """
#include <iostream>
#include "k_arm/arm_parameters.hpp"
double sum_of_gains(const arm_driver::Params & params);
int main(int argc, char ** argv)
{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("arm");
  std::shared_ptr<arm_driver::ParamListener> listener;
  try {
    listener = std::make_shared<arm_driver::ParamListener>(node);
  } catch (const std::exception & error) {
    std::cout << error.what() << std::endl;
    return 1;
  }
  int calls = 0;
  listener->setUserCallback([&calls](const arm_driver::Params &) {++calls;});
  auto params = listener->get_params();
  std::cout << params.rate << params.mode << params.count << rsl::to_string(params.tag) << " " << sum_of_gains(params);
  std::cout << std::endl;
  auto told = node->describe_parameter("rate");
  std::cout << told.description << " " << told.floating_point_range[0].to_value << std::endl;

  auto set = [&](const rclcpp::Parameter & parameter) {
      auto result = node->set_parameter(parameter);
      std::cout << result.successful << result.reason << listener->is_old(params) << std::endl;
    };
  set({"count", 4});
  set({"count", 5});
  listener->try_get_params(params);
  set({"gains.left.p", 0.1});
  set({"tag", "much too long"});
  set({"ranks", std::vector<int64_t>{3, 1, 2}});
  set({"joints", std::vector<std::string>{"left", "left"}});
  set({"joints", std::vector<std::string>{"left", "third"}});
  listener->refresh_dynamic_parameters();
  params = listener->get_params();
  int ranks = 0;
  for (int64_t rank : params.ranks) {ranks = 10 * ranks + static_cast<int>(rank);}
  std::cout << params.count << " " << ranks << " " << node->has_parameter("gains.third.p") << " "
            << params.gains.joints_map.count("right") << params.gains.joints_map.at("third").p << " "
            << listener->get_stack_params().count << " " << calls << std::endl;
}
"""
TEST = """
#include "gtest/gtest.h"
#include "arm_parameters.hpp"
TEST(Arm, has_the_file_s_parameters)
{
  arm_driver::ParamListener listener(std::make_shared<rclcpp::Node>("arm"));
  EXPECT_EQ(listener.get_params().joints.at(0), "elbow");
}
int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  rclcpp::init(argc, argv);
  return RUN_ALL_TESTS();
}
"""
VALUES = "arm: {ros__parameters: {joints: [elbow]}}\n"
FILES = {
    "package.xml": MANIFEST, "CMakeLists.txt": CMAKE, "src/arm.yaml": YAML, "include/k_arm/arm_checks.hpp": CHECKS,
    "src/read.cpp": READ, "src/arm.cpp": PROGRAM, "test/test_arm.cpp": TEST, "test/arm.yaml": VALUES,
}  # fmt: skip
GIVEN = "-p rate:=20.0 -p joints:=[left,right] -p gains.left.p:=1.5"
RAN = """\
20slow3tag 18
How often, in "Hz" 1000
0count is even0
11
0Parameter {gains.left.p} doesn't comply with floating point range.0
0Length of parameter 'tag' is '13' but must be less than '9'0
11
0Parameter 'joints' must only contain unique values1
11
5 312 1 02.5 5 5
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    compiler_or_skip()
    folder = tmp_path_factory.mktemp("parameters")
    for name, text in FILES.items():
        path = folder / "src" / "k_arm" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")
    built = colcon(folder, "build")
    assert built.returncode == 0 and "Skipped C++" not in built.stdout + built.stderr, built.stdout + built.stderr
    return folder


def test_a_listener_follows_the_node_s_parameters(folder):
    ran = sourced(folder, f"ros2 run k_arm arm --ros-args {GIVEN}")
    assert ran.stdout == RAN, ran.stdout + ran.stderr


def test_what_is_missing_or_wrong_at_the_start_is_an_exception(folder):
    missing = sourced(folder, "ros2 run k_arm arm")
    assert "parameter 'joints' is not initialized" in missing.stdout, missing.stdout + missing.stderr
    wrong = sourced(folder, "ros2 run k_arm arm --ros-args -p joints:=[a] -p mode:=never")
    assert wrong.stdout.startswith(
        "Invalid value set during initialization for parameter 'mode': Parameter 'mode' with the value 'never' is not in "
        "the set '{slow, fast}'\n"
    )
    assert missing.returncode == wrong.returncode == 1


def test_its_tests_are_given_a_file_of_parameters(folder):
    tested = colcon(folder, "test")
    text = tested.stdout + tested.stderr
    if "libgtest-dev" in text or "gtest is not here" in text:
        pytest.skip("needs gtest")
    results = colcon(folder, "test-result", "--all")
    assert "1 test, 0 errors, 0 failures, 0 skipped" in results.stdout, text + results.stdout
