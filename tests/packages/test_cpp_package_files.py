"""What packages in C++ consist of beside programs: extras for those that find them, written tests, local_setup, IDL."""

from __future__ import annotations

import pytest

from tests.packages.test_cpp_libraries import built, lay_out
from tests.packages.test_cpp_workspace import colcon, scripted, sourced

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
EXTRAS_CMAKE = """
set(${PROJECT_NAME}_CONFIG_EXTRAS "cmake/k_extras-extras.cmake")
if(BUILD_TESTING)
  find_package(ament_cmake_pytest REQUIRED)
  configure_file(test/test_x.py.in ${CMAKE_CURRENT_BINARY_DIR}/test_x.py @ONLY)
  ament_add_pytest_test(x ${CMAKE_CURRENT_BINARY_DIR}/test_x.py)
  file(GENERATE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/test_y_$<CONFIG>.py" CONTENT "def test_y():\\n    assert True\\n")
  ament_add_pytest_test(y "${CMAKE_CURRENT_BINARY_DIR}/test_y_$<CONFIG>.py")
endif()
ament_package()
"""
FINDING_CMAKE = """
find_package(k_extras REQUIRED)
if(NOT K_EXTRAS_SAID EQUAL 42)
  message(FATAL_ERROR "no extras")
endif()
install(CODE "message(STATUS done)")
add_library(nothing INTERFACE)
ament_package()
"""


def test_a_package_of_extras_alone_gives_them_to_others_and_has_the_tests_that_cmake_writes_run(tmp_path):
    in_python = "def test_x():\n    assert '@PROJECT_NAME@' == 'k_extras'\n"
    files = {"cmake/k_extras-extras.cmake": "set(K_EXTRAS_SAID 42)\n", "test/test_x.py.in": in_python}
    lay_out(tmp_path, "k_extras", EXTRAS_CMAKE, files)
    lay_out(tmp_path, "k_finding", FINDING_CMAKE, {}, ("k_extras",))
    built(tmp_path)
    assert colcon(tmp_path, "test", "--packages-select", "k_extras").returncode == 0
    results = tmp_path.glob("build/k_extras/test_results/k_extras/*.xml")
    assert sorted(path.name for path in results) == ["x.xunit.xml", "y.xunit.xml"]


def test_a_package_is_sourced_by_itself(tmp_path):
    lay_out(tmp_path, "k_alone", "ament_package()", {})
    built(tmp_path)
    for line in ("source install/k_alone/share/k_alone/local_setup.bash", ". install/k_alone/share/k_alone/local_setup.sh"):
        said = sourced(tmp_path, f"unset AMENT_PREFIX_PATH; {line}; echo $AMENT_PREFIX_PATH").stdout
        assert said.strip() == str(tmp_path / "install/k_alone")


IDL = """
module k_idl { module msg {
  module Spot_Constants { const short MOST = 3; };
  struct Spot { @default (value=1.5) double x; sequence<geometry_msgs::msg::Point> path; };
}; };
"""
IDL_CMAKE = """
find_package(geometry_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME} "msg/Spot.idl" DEPENDENCIES geometry_msgs)
add_executable(says src/says.cpp)
rosidl_get_typesupport_target(support ${PROJECT_NAME} rosidl_typesupport_cpp)
target_link_libraries(says ${support})
install(TARGETS says DESTINATION lib/${PROJECT_NAME})
ament_package()
"""
SAYS = """
#include <iostream>
#include "k_idl/msg/spot.hpp"
int main() {std::cout << k_idl::msg::Spot().x << k_idl::msg::Spot::MOST << k_idl::msg::Spot().path.size() << std::endl;}
"""


def test_interfaces_may_be_written_in_idl(tmp_path):
    files = {"msg/Spot.idl": IDL, "src/says.cpp": SAYS}
    lay_out(tmp_path, "k_idl", IDL_CMAKE, files, ("geometry_msgs",))
    manifest = tmp_path / "src/k_idl/package.xml"
    member = "<member_of_group>rosidl_interface_packages</member_of_group><export>"
    manifest.write_text(manifest.read_text(encoding="utf-8").replace("<export>", member), encoding="utf-8")
    built(tmp_path)
    assert sourced(tmp_path, "ros2 run k_idl says").stdout == "1.530\n"
    assert scripted(tmp_path, "from k_idl.msg import Spot\nprint(Spot().x, Spot.MOST)\n").stdout == "1.5 3\n"
    assert "float64 x 1.5" in sourced(tmp_path, "ros2 interface show k_idl/msg/Spot").stdout
