"""A workspace of packages in C++, built by colcon with real CMake, and run among Python's programs on the virtual clock."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.cpp.toolchain import NoToolchain, find_toolchain
from tests.needs import ON_WINDOWS

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
SOURCES = Path(__file__).parent.parent / "fixtures" / "cpp_ws" / "src"
BIN = Path(sys.executable).parent
ENV = {k: v for k, v in os.environ.items() if k not in ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "PYTHONPATH")}
ENV |= {"PATH": f"{BIN}{os.pathsep}{ENV['PATH']}", "COURSEKIT_TIME": "virtual"}


def colcon(folder, *words):
    command = [str(BIN / "colcon"), "--log-base", "log", *words]
    return subprocess.run(command, cwd=folder, env=ENV, capture_output=True, encoding="utf-8", check=False)


def sourced(folder, command):
    line = f"source install/setup.bash && {command}"
    return subprocess.run(["bash", "-c", line], cwd=folder, env=ENV, capture_output=True, encoding="utf-8", check=False)


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    if ON_WINDOWS:
        pytest.skip("Windows: C++ is not compiled there yet")
    try:
        find_toolchain()
    except NoToolchain as error:
        pytest.skip(str(error))
    folder = tmp_path_factory.mktemp("cpp_ws")
    shutil.copytree(SOURCES, folder / "src")
    built = colcon(folder, "build")
    assert built.returncode == 0 and "5 packages finished" in built.stdout, built.stdout + built.stderr
    assert "stderr" not in built.stdout + built.stderr
    return folder


def test_nodes_of_a_launch_file_speak_at_exact_times(workspace):
    said = sourced(workspace, "COURSEKIT_STOP_AFTER=0.8 ros2 launch k_survey survey.launch.py").stdout
    spoken = [line for line in said.splitlines() if "[surveyor]: leg" in line]
    assert spoken == [
        f"[surveyor-2] [INFO] [1700000000.{250 * leg:03}000000] [surveyor]: leg {leg} ends at x = {2 * leg}.00"
        for leg in (1, 2, 3)
    ]
    assert "process has died" not in said


TOGETHER = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session
from k_survey.msg import Leg
import rclpy

with (session := Session(virtual=True)).use():
    def start(package, name, *words):
        return session.launch(make_process(session, find(package, name), words, name=name))
    surveyor, asker = start("k_survey", "surveyor"), start("k_auto", "asker")
    print(asker.wait(10.0), asker.output, end="")
    scout = start("k_survey", "scout", "--ros-args", "-p", "step:=2.5", "-r", "__node:=ada")
    heard = []
    rclpy.init()
    node = rclpy.create_node("listener")
    node.create_subscription(Leg, "legs", heard.append, 10)
    while len(heard) < 3:
        rclpy.spin_once(node)
    total = sum(leg.to_point.x - leg.from_point.x for leg in heard)
    print(total, heard[-1].header.stamp.nanosec - heard[-2].header.stamp.nanosec, *sorted(node.get_node_names()))
    surveyor.interrupt(), scout.interrupt()
    print(scout.wait(3.0), surveyor.wait(3.0))
"""


def test_programs_of_both_languages_meet_on_topics_and_services(workspace):
    said = sourced(workspace, f"'{sys.executable}' - <<'END'\n{TOGETHER}END")
    assert said.stdout == "0 length 7\n7.5 250000000 ada listener surveyor\n0 0\n", said.stdout + said.stderr


ALONE = """
from coursekit.processes.executables import find, make_process
from coursekit.processes.session import Session

with (session := Session(virtual={virtual})).use():
    def start(name, *words):
        return session.launch(make_process(session, find("k_parts", name), words, name=name))
    {what}
"""


def alone(workspace, what, virtual=True):
    """What a script prints that starts programs of k_parts in a session of its own."""
    text = ALONE.format(what=what.replace("\n", "\n    "), virtual=virtual)
    done = sourced(workspace, f"'{sys.executable}' - <<'END'\n{text}END")
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.parametrize("virtual", [True, False])
def test_an_action_is_rejected_canceled_and_done(workspace, virtual):
    what = "winch, winder = start('winch_node'), start('winder')\nprint(winder.wait(20.0), winder.output)\nwinch.interrupt()"
    said = alone(workspace, f"{what}\nprint(winch.wait(5.0), winch.output)", virtual)
    assert said.startswith(
        "0 nothing to wind: rejected\ntaken\ncanceling 1: canceled\ntaken\n2 left\n1 left\n0 left\nsucceeded after 3\n"
    )
    told = [line.rpartition("[winch]: ")[2] for line in said.splitlines() if "[winch]: " in line]
    assert told == ["asked for 0 turns", "asked for 50 turns", "canceled", "asked for 3 turns", "done"]
    if virtual:
        assert "[INFO] [1700000000.300000000] [winch]: canceled" in said
        assert "[INFO] [1700000000.600000000] [winch]: done" in said


def test_transforms_are_broadcast_waited_for_and_refused(workspace):
    said = alone(workspace, "mast = start('mast')\nprint(mast.wait(5.0), mast.output)")
    assert said == (
        '0 [WARN] [1700000000.350000000] [mast]: "nowhere" passed to lookupTransform argument source_frame '
        "does not exist. \n"
        "[INFO] [1700000000.350000000] [mast]: (0.00, 3.00, 1.00) in world, yaw 1.5708\n\n"
    )


def test_a_container_loads_a_compiled_component_under_another_name(workspace):
    said = sourced(workspace, "COURSEKIT_STOP_AFTER=3 ros2 launch k_parts container.launch.py").stdout
    assert "[component_container-1] [INFO] [1700000000.000000000] [yard]: Instantiate class: " in said
    assert "[left_winch]: done" in said and "[winder-2] succeeded after 3" in said, said


def test_interfaces_of_a_package_with_nodes_are_python_s_too(workspace):
    code = "from k_survey.msg import Leg; from k_survey.srv import MeasureRoute as M; print(Leg().remarks, M.Response())"
    said = sourced(workspace, f'"{sys.executable}" -c "{code}" && ros2 interface show k_survey/srv/MeasureRoute')
    assert said.stdout.startswith("[] k_survey.srv.MeasureRoute_Response(length=0.0, closed=False)\n"), said.stderr
    assert "\tgeometry_msgs/Point from_point\n" in said.stdout


def test_a_second_build_compiles_what_changed_and_nothing_else(workspace):
    program, other = (workspace / "install/k_survey/lib/k_survey" / name for name in ("scout", "surveyor"))
    objects = workspace / "build/k_survey/CMakeFiles"
    before = {path: path.stat().st_mtime_ns for path in objects.rglob("*.o")}
    source = workspace / "src/k_survey/src/scout.cpp"
    source.write_text(source.read_text().replace('"leg "', '"walk "'))
    assert colcon(workspace, "build", "--packages-select", "k_survey").returncode == 0
    changed = [path.name for path, stamp in before.items() if path.stat().st_mtime_ns != stamp]
    assert changed == ["scout.cpp.o"]
    assert b"walk " in program.read_bytes() and b"walk " not in other.read_bytes()


def test_a_package_that_ros2_pkg_creates_builds_and_runs(workspace, tmp_path):
    (tmp_path / "src").mkdir()
    words = "--build-type ament_cmake --node-name hello --dependencies rclcpp --destination-directory src first_steps"
    assert sourced(workspace, f"ros2 pkg create {words.replace('src ', str(tmp_path / 'src') + ' ')}").returncode == 0
    assert colcon(tmp_path, "build").returncode == 0
    assert sourced(tmp_path, "ros2 run first_steps hello").stdout == "hello world first_steps package\n"


def test_tests_in_cpp_are_built_and_run_or_named(workspace):
    tested = colcon(workspace, "test", "--packages-select", "k_route")
    assert tested.returncode == 0, tested.stdout + tested.stderr
    if not os.path.isfile("/usr/include/gtest/gtest.h"):
        assert "Skipped tests of k_route: test_route, test_with_node" in tested.stdout
        assert "sudo apt install libgtest-dev libgmock-dev" in tested.stdout + tested.stderr
        return
    assert colcon(workspace, "test-result").stdout == "Summary: 2 tests, 0 errors, 0 failures, 0 skipped\n"
    source = workspace / "src" / "k_route" / "test" / "test_route.cpp"
    right = source.read_text(encoding="utf-8")
    source.write_text(right + "TEST(Route, fails) {EXPECT_EQ(1, 2);}\n", encoding="utf-8")
    colcon(workspace, "test", "--packages-select", "k_route")
    source.write_text(right, encoding="utf-8")
    told = colcon(workspace, "test-result", "--verbose").stdout
    assert "Summary: 3 tests, 0 errors, 1 failure, 0 skipped" in told and "test_route.cpp" in told


FIRST_TEST = """#include <gtest/gtest.h>
TEST(first, sum) {ASSERT_EQ(4, 2 + 2);}
int main(int argc, char ** argv) {testing::InitGoogleTest(&argc, argv); return RUN_ALL_TESTS();}
"""


@pytest.mark.skipif(not os.path.isfile("/usr/include/gtest/gtest.h"), reason="needs libgtest-dev")
def test_a_package_of_nothing_but_tests_in_cpp_has_them_run(workspace, tmp_path):
    (tmp_path / "src").mkdir()
    words = f"--build-type ament_cmake --destination-directory {tmp_path / 'src'} only_tests"
    assert sourced(workspace, f"ros2 pkg create {words}").returncode == 0
    package = tmp_path / "src" / "only_tests"
    (package / "test").mkdir()
    (package / "test" / "first.cpp").write_text(FIRST_TEST, encoding="utf-8")
    tests = "find_package(ament_cmake_gtest REQUIRED)\n  ament_add_gtest(only_first test/first.cpp)\n"
    rules = (package / "CMakeLists.txt").read_text(encoding="utf-8")
    rules = rules.replace("ament_package()", f"if(BUILD_TESTING)\n  {tests}endif()\nament_package()")
    (package / "CMakeLists.txt").write_text(rules, encoding="utf-8")
    assert colcon(tmp_path, "build").returncode == 0
    tested = colcon(tmp_path, "test")
    assert "Skipped" not in tested.stdout, tested.stdout
    assert colcon(tmp_path, "test-result").stdout == "Summary: 1 test, 0 errors, 0 failures, 0 skipped\n"


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


def test_a_package_that_names_rosbag2_cpp_records_what_is_published(workspace, tmp_path):
    (tmp_path / "src").mkdir()
    needs = "rclcpp rosbag2_cpp example_interfaces"
    words = f"--build-type ament_cmake --destination-directory {tmp_path / 'src'} k_bags --dependencies {needs}"
    assert sourced(workspace, f"ros2 pkg create {words}").returncode == 0
    package = tmp_path / "src" / "k_bags"
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


def copied(tmp_path, package):
    shutil.copytree(SOURCES / package, tmp_path / "src" / package)
    return tmp_path / "src" / package


def test_a_mistake_is_shown_by_the_compiler_with_a_hint(workspace, tmp_path):
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


def test_a_package_that_needs_what_only_a_robot_has_keeps_its_files(workspace, tmp_path):
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


def test_a_package_whose_name_is_misspelled_is_told(workspace, tmp_path):
    package = copied(tmp_path, "k_geometry")
    text = (package / "CMakeLists.txt").read_text()
    (package / "CMakeLists.txt").write_text(text.replace("find_package(geometry_msgs", "find_package(geometry_mgs"))
    built = colcon(tmp_path, "build")
    assert built.returncode == 1
    assert 'By not providing "Findgeometry_mgs.cmake"' in built.stderr
    assert "hint: CMakeLists.txt:5: there is no package geometry_mgs" in built.stderr


def test_a_mistake_in_a_package_that_coursekit_has_programs_for_is_its_author_s(tmp_path, workspace):
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
