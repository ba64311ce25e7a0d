"""Targets in C++ that need what is not here are left out; the rest of their package is built, installed and run."""

from __future__ import annotations

import pytest

from tests.needs import compiler_or_skip
from tests.packages.test_cpp_libraries import lay_out
from tests.packages.test_cpp_workspace import colcon, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]

CMAKE = """
find_package(rclcpp REQUIRED)
find_package(rclcpp_components REQUIRED)
add_executable(plain src/plain.cpp)
ament_target_dependencies(plain rclcpp)
add_executable(more src/more.cpp)
ament_target_dependencies(more rclcpp)
add_library(part SHARED src/part.cpp)
ament_target_dependencies(part rclcpp rclcpp_components)
rclcpp_components_register_node(part PLUGIN "Part" EXECUTABLE part_exe)
install(TARGETS plain more DESTINATION lib/${PROJECT_NAME})
install(TARGETS part ARCHIVE DESTINATION lib LIBRARY DESTINATION lib RUNTIME DESTINATION bin)
ament_package()
"""
MORE = "nav2_util/costmap.hpp"
PART = """
#include "rclcpp/rclcpp.hpp"
#include "rmw/features.h"
#include "rclcpp_components/register_node_macro.hpp"
class Part : public rclcpp::Node {public: explicit Part(const rclcpp::NodeOptions & o) : Node("part", o) {}};
RCLCPP_COMPONENTS_REGISTER_NODE(Part)
"""
FILES = {
    "src/plain.cpp": '#include "rclcpp/rclcpp.hpp"\nint main() {std::cout << "plain" << std::endl;}\n',
    "src/more.cpp": f'#include "{MORE}"\nint main() {{}}\n',
    "src/part.cpp": PART,
}


@pytest.fixture
def package(tmp_path):
    compiler_or_skip()
    lay_out(tmp_path, "k_parts", CMAKE, FILES, ("rclcpp", "rclcpp_components"))
    return tmp_path / "src" / "k_parts"


def test_the_other_targets_are_built_and_run(package, tmp_path):
    done = colcon(tmp_path, "build")
    assert done.returncode == 0 and "stderr" not in done.stdout + done.stderr, done.stdout + done.stderr
    missing = {name: f"{name} is not among what C++ has here" for name in (MORE, "rmw/features.h")}
    line = next(line for line in done.stdout.splitlines() if line.startswith("Skipped C++ of k_parts: "))
    assert {"more", "part"} == set(line.split(": ")[1].split(" (")[0].split(", "))
    assert all(text in line for text in missing.values()) and line.endswith("; the rest is installed)")
    said = sourced(tmp_path, "ros2 run k_parts plain; ros2 run k_parts more; ros2 component types")
    assert said.stdout.startswith("plain\n") and "k_parts" not in said.stdout
    assert "'more' is written in C++, which the last build of 'k_parts' skipped" in said.stderr


def test_what_no_longer_needs_it_is_built_again(package, tmp_path):
    assert "Skipped C++" in colcon(tmp_path, "build").stdout
    (package / "src" / "more.cpp").write_text("int main() {}\n")
    (package / "src" / "part.cpp").write_text(PART.replace('#include "rmw/features.h"\n', ""))
    again = colcon(tmp_path, "build")
    assert again.returncode == 0 and "Skipped" not in again.stdout
    assert sourced(tmp_path, "ros2 pkg executables k_parts").stdout.split()[1::2] == ["more", "part_exe", "plain"]
    assert "k_parts\n  Part\n" in sourced(tmp_path, "ros2 component types").stdout


def test_a_mistake_beside_them_is_still_the_author_s(package, tmp_path):
    (package / "src" / "plain.cpp").write_text("int main() {return zero;}\n")
    done = colcon(tmp_path, "build")
    assert done.returncode == 1 and "'zero' was not declared" in done.stderr.replace("‘", "'").replace("’", "'")
    assert "nav2_util/costmap" not in done.stderr and "Skipped" not in done.stdout


def test_a_target_that_nobody_has_made_is_not_left_out_in_silence(package, tmp_path):
    file = package / "CMakeLists.txt"
    file.write_text(file.read_text().replace("TARGETS plain more", "TARGETS plian"))
    done = colcon(tmp_path, "build")
    assert done.returncode == 1 and 'install TARGETS given target "plian" which does not exist' in done.stderr


SIMULATED = """
find_package(rclcpp REQUIRED)
find_package(gazebo_ros REQUIRED)
find_package(gazebo_plugins REQUIRED)
add_executable(driver src/driver.cpp)
ament_target_dependencies(driver rclcpp)
add_library(wind SHARED src/wind.cpp)
ament_target_dependencies(wind gazebo_ros)
install(TARGETS driver DESTINATION lib/${PROJECT_NAME})
install(TARGETS wind DESTINATION lib)
ament_package()
"""


def test_a_package_that_starts_gazebo_is_built_and_a_plugin_of_gazebo_is_left_out(tmp_path):
    compiler_or_skip()
    plugin = "#include <gazebo/gazebo.hh>\nnamespace gazebo {class Wind : public WorldPlugin {};}\n"
    files = {"src/driver.cpp": FILES["src/plain.cpp"], "src/wind.cpp": plugin}
    lay_out(tmp_path, "k_wind", SIMULATED, files, ("rclcpp", "gazebo_ros", "gazebo_plugins"))
    done = colcon(tmp_path, "build")
    assert done.returncode == 0, done.stdout + done.stderr
    why = "gazebo/gazebo.hh is not among what C++ has here; the rest is installed"
    assert f"Skipped C++ of k_wind: wind ({why})" in done.stdout
    assert sourced(tmp_path, "ros2 run k_wind driver").stdout == "plain\n"
