"""Real colcon builds the ten packages of the fixture workspace, and says what is wrong in others."""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from coursekit.systems.links import can_link
from tests.needs import ON_WINDOWS, compiler_or_skip

WORKSPACE = Path(__file__).parent.parent / "fixtures" / "ros2_ws"
BIN = Path(sys.executable).parent
ENV = {k: v for k, v in os.environ.items() if k not in ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "PYTHONPATH")}
ENV["PATH"] = f"{BIN}{os.pathsep}{ENV['PATH']}"
ENV["CMAKE"] = "/nonexistent"


def colcon(folder, *args):
    """Run colcon in a folder."""
    command = [str(BIN / "colcon"), "--log-base", "log", *args]
    return subprocess.run(command, cwd=folder, env=ENV, capture_output=True, encoding="utf-8", check=False)


def sourced(folder, command):
    """Run a shell command after `source install/setup.bash`."""
    if ON_WINDOWS:
        pytest.skip("Windows: there is no bash to source setup.bash")
    line = f"source install/setup.bash && {command}"
    result = subprocess.run(["bash", "-c", line], cwd=folder, env=ENV, capture_output=True, encoding="utf-8", check=True)
    return result.stdout


PACKAGE = """<package format="3"><name>{name}</name><version>0.0.0</version><description>d</description>
<maintainer email="a@b.org">a</maintainer><license>MIT</license>
<buildtool_depend>ament_cmake</buildtool_depend><export><build_type>ament_cmake</build_type></export></package>"""


@pytest.fixture(scope="module")
def built(tmp_path_factory):
    """The fixture workspace, built with --symlink-install; its output in `.output`."""
    folder = tmp_path_factory.mktemp("ws")
    shutil.copytree(WORKSPACE / "src", folder / "src")
    result = colcon(folder, "build", "--symlink-install", "--executor", "sequential")
    assert result.returncode == 0, result.stdout + result.stderr
    (folder / "output.txt").write_text(result.stdout)
    return folder


def test_all_ten_packages_are_built_in_order(built):
    output = (built / "output.txt").read_text()
    assert "Summary: 10 packages finished" in output
    order = [line.split()[2] for line in output.splitlines() if line.startswith("Finished <<<")]
    assert order.index("s4_custom_interface") < order.index("s4_py_apps")


def test_programs_in_cpp_are_compiled_and_installed(built):
    compiler_or_skip()
    assert "Skipped C++" not in (built / "output.txt").read_text()
    said = sourced(built, f'"{BIN}/ros2" pkg executables s2_cpp_pubsub')
    assert said.split() == ["s2_cpp_pubsub", "publisher_exe", "s2_cpp_pubsub", "subscriber_exe"]
    assert (built / "install/s2_cpp_pubsub/share/s2_cpp_pubsub/launch/pair.launch.py").is_file()


@pytest.fixture(scope="module")
def without_compiler(tmp_path_factory):
    """A workspace with a package in C++, built where there is neither a compiler nor CMake; its output in `.output`."""
    if ON_WINDOWS:
        pytest.skip("Windows: links to programs of the system may not be made")
    folder = tmp_path_factory.mktemp("without")
    shutil.copytree(WORKSPACE / "src" / "s2_cpp_pubsub", folder / "src" / "s2_cpp_pubsub")
    (folder / "bin").mkdir()
    for name in ("env", "sh"):  # what colcon's own scripts need
        (folder / "bin" / name).symlink_to(shutil.which(name))
    env = {**ENV, "PATH": f"{BIN}{os.pathsep}{folder / 'bin'}"}
    result = subprocess.run([str(BIN / "colcon"), "build"], cwd=folder, env=env, capture_output=True, encoding="utf-8")
    assert result.returncode == 0, result.stdout + result.stderr
    (folder / "output.txt").write_text(result.stdout)
    return folder


def test_without_a_compiler_cpp_is_skipped_in_one_line(without_compiler):
    lines = [line for line in (without_compiler / "output.txt").read_text().splitlines() if "C++ of s2_cpp_pubsub" in line]
    assert lines == [
        "Skipped C++ of s2_cpp_pubsub: publisher_exe, subscriber_exe (there is no CMake here: "
        '`pip install "coursekit[cpp]"` brings all that C++ needs; the rest is installed)'
    ]
    assert (without_compiler / "install/s2_cpp_pubsub/share/s2_cpp_pubsub/launch/pair.launch.py").is_file()


@pytest.mark.parametrize("command", ["run s2_cpp_pubsub publisher_exe", "launch s2_cpp_pubsub pair.launch.py"])
def test_an_executable_that_was_skipped_is_told_as_such(without_compiler, command):
    said = sourced(without_compiler, f'COURSEKIT_TIME=virtual "{BIN}/ros2" {command} 2>&1 || true')
    assert "'publisher_exe' is written in C++, which the last build of 's2_cpp_pubsub' skipped" in said


def test_coursekits_own_programs_answer_for_those_of_a_clone_that_are_written_in_cpp(tmp_path):
    """Whoever clones turtlesim, as the tutorials say, still has a turtle."""
    folder = tmp_path / "src" / "turtlesim"
    folder.mkdir(parents=True)
    (folder / "package.xml").write_text(PACKAGE.format(name="turtlesim"))
    (folder / "CMakeLists.txt").write_text(
        "cmake_minimum_required(VERSION 3.8)\nproject(turtlesim)\nfind_package(ament_cmake REQUIRED)\n"
        "find_package(Qt5 REQUIRED COMPONENTS Widgets)\nadd_executable(turtlesim_node a.cpp)\n"
        "install(TARGETS turtlesim_node DESTINATION lib/turtlesim)\nament_package()\n"
    )
    (folder / "a.cpp").write_text("int main() {}\n")
    without_qt = [f"-DCMAKE_FIND_USE_{kind}_PATH=OFF" for kind in ("CMAKE_SYSTEM", "SYSTEM_ENVIRONMENT")]
    said = colcon(tmp_path, "build", "--cmake-args", *without_qt).stdout
    assert "coursekit's own draw_square, mimic, turtle_teleop_key, turtlesim_node answer in their place" in said
    listed = sourced(tmp_path, f'"{BIN}/ros2" pkg executables turtlesim; "{BIN}/ros2" pkg prefix turtlesim').splitlines()
    assert "turtlesim turtlesim_node" in listed and listed[-1] == str(tmp_path / "install" / "turtlesim")


def test_interfaces_can_be_imported_after_sourcing(built):
    code = (
        "import s4_custom_interface.msg as m, s4_custom_interface.srv as s, s4_custom_interface.action as a; "
        "print(m.Sphere(radius=2.0), s.AddThreeInts.Request(a=1), a.CountTo.Goal())"
    )
    assert sourced(built, f'"{sys.executable}" -c "{code}"').split(" s4")[0] == (
        "s4_custom_interface.msg.Sphere(center=geometry_msgs.msg.Point(x=0.0, y=0.0, z=0.0), radius=2.0)"
    )


def test_the_index_is_sourced_although_it_was_empty(built):
    code = "from ament_index_python import *; print(get_package_prefix('s5_bringup')); "
    code += "print(get_resource('rosidl_interfaces', 's4_custom_interface')[0])"
    prefix, *files = sourced(built, f'"{sys.executable}" -c "{code}"').split()
    assert prefix == str(built / "install" / "s5_bringup")
    assert files == [
        "msg/HardwareStatus.msg",
        "msg/Sphere.msg",
        "srv/AddThreeInts.srv",
        "action/CountTo.action",
    ]


def test_files_scripts_and_python_modules_are_installed(built):
    share = built / "install/s5_bringup/share/s5_bringup"
    assert sorted(p.name for p in (share / "config").iterdir()) == ["first.yaml"]
    assert sorted(p.name for p in (share / "launch").iterdir()) == [
        "all.launch.py",
        "pair.launch.xml",
        "pair.launch.yaml",
    ]
    assert sourced(built, "install/s4_cpp_apps/lib/s4_cpp_apps/report") == "installed without a compiler\n"


def test_symlinks_follow_the_source(built):
    if not can_link(built):
        pytest.skip("this account may not make links")
    path = built / "install/s4_custom_interface/share/s4_custom_interface/msg/Sphere.msg"
    assert path.samefile(built / "src/s4_custom_interface/msg/Sphere.msg")


def test_colcon_test_runs_the_tests_of_a_package(built):
    result = colcon(built, "test", "--packages-select", "s2_py_pubsub", "s5_bringup")
    assert "Skipped tests of s5_bringup: it has none" in result.stdout
    assert "1 test, 0 errors, 0 failures" in colcon(built, "test-result", "--all").stdout


@pytest.fixture
def interface_package(tmp_path):
    """A copy of s4_custom_interface in a workspace of its own."""
    shutil.copytree(WORKSPACE / "src" / "s4_custom_interface", tmp_path / "src" / "s4_custom_interface")
    return tmp_path / "src" / "s4_custom_interface"


def build_errors(package):
    """Build the workspace of a package; return its exit code and stderr."""
    result = colcon(package.parent.parent, "build")
    return result.returncode, result.stderr


def test_a_type_without_its_package_is_looked_for_in_those_that_are_named(interface_package):
    (interface_package / "msg" / "Sphere.msg").write_text("Point center\nfloat64 radius\n")
    assert "unknown type 'Point'; did you mean 'geometry_msgs/Point'?\n" in build_errors(interface_package)[1]


def test_a_type_of_its_own_that_is_not_listed_is_asked_for_in_cmake(interface_package):
    (interface_package / "msg" / "Sphere.msg").write_text("Middle center\nfloat64 radius\n")
    assert "unknown type 'Middle'; is it in CMakeLists.txt?\n" in build_errors(interface_package)[1]


def test_a_bad_interface_fails_its_package_with_file_line_and_caret(interface_package):
    (interface_package / "msg" / "Sphere.msg").write_text("geometry_msgs/Point center\nflot64 radius\n")
    code, errors = build_errors(interface_package)
    path = interface_package / "msg" / "Sphere.msg"
    assert code == 1
    assert f"{path}:2:1: unknown type 'flot64'; did you mean 'float64'?\n  flot64 radius\n  ^\n" in errors


def test_a_missing_dependency_is_named(interface_package):
    (interface_package / "msg" / "Sphere.msg").write_text("nav_msgs/Path p\nnope_msgs/X x\nNope y\n")
    code, errors = build_errors(interface_package)
    assert code == 1
    assert "'nav_msgs/Path' needs DEPENDENCIES nav_msgs in rosidl_generate_interfaces()" in errors
    assert "no package nope_msgs with such a message" in errors
    assert "unknown type 'Nope'" in errors


def test_a_missing_group_or_generator_is_named(interface_package):
    manifest = interface_package / "package.xml"
    manifest.write_text(manifest.read_text().replace("<member_of_group>rosidl_interface_packages</member_of_group>", ""))
    cmake = interface_package / "CMakeLists.txt"
    cmake.write_text(cmake.read_text().replace("find_package(rosidl_default_generators REQUIRED)", ""))
    code, errors = build_errors(interface_package)
    assert code == 1 and "find_package(rosidl_default_generators REQUIRED)" in errors


def test_a_bad_maintainer_email_is_shown(interface_package):
    manifest = interface_package / "package.xml"
    manifest.write_text(manifest.read_text().replace("student@example.com", "student at example"))
    code, errors = build_errors(interface_package)
    assert code == 1 and 'Invalid email "student at example"' in errors


def test_an_interface_taken_away_is_uninstalled(interface_package):
    assert build_errors(interface_package)[0] == 0
    cmake = interface_package / "CMakeLists.txt"
    cmake.write_text(cmake.read_text().replace('"msg/HardwareStatus.msg"', ""))
    assert build_errors(interface_package)[0] == 0
    share = interface_package.parent.parent / "install/s4_custom_interface/share/s4_custom_interface"
    assert [p.name for p in (share / "msg").iterdir()] == ["Sphere.msg"]


@pytest.mark.parametrize("shell", ["sh", "bash", "zsh"])
def test_folders_and_interpreters_may_have_any_name(tmp_path, shell):
    if shutil.which(shell) is None:
        pytest.skip(f"NOT TESTED: no {shell} here")
    folder = tmp_path / "José's ws (2)"
    (folder / "src").mkdir(parents=True)
    shutil.copytree(WORKSPACE / "src" / "s2_py_pubsub", folder / "src" / "s2_py_pubsub")
    result = colcon(folder, "build", "--executor", "sequential")
    assert result.returncode == 0, result.stdout + result.stderr
    (tmp_path / "a python").symlink_to(sys.executable)
    command = [shell, "-c", '. ./install/setup.$0 && echo "$AMENT_PREFIX_PATH"', shell]
    env = {**ENV, "COLCON_PYTHON_EXECUTABLE": str(tmp_path / "a python")}
    done = subprocess.run(command, cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)
    assert (done.stdout.strip(), done.stderr) == (str(folder / "install" / "s2_py_pubsub"), "")


def test_a_plain_shell_knows_which_ros_it_is_after_sourcing(built, monkeypatch):
    for name in ("ROS_DISTRO", "ROS_VERSION", "ROS_PYTHON_VERSION"):
        monkeypatch.delitem(ENV, name, raising=False)
    assert sourced(built, "echo $ROS_DISTRO $ROS_VERSION $ROS_PYTHON_VERSION") == "humble 2 3\n"


@pytest.mark.parametrize(
    ("written", "said"),
    [
        ('"msg/Nope.msg"', "passed file 'msg/Nope.msg' doesn't exist relative to the CMAKE_CURRENT_SOURCE_DIR '{at}'"),
        ('"${CMAKE_CURRENT_SOURCE_DIR}/msg/Sphere.msg"', "absolute file '{at}/msg/Sphere.msg' must be represented"),
        ('"${CMAKE_CURRENT_SOURCE_DIR}:msg/Nope.msg"', "the passed file '{at}:msg/Nope.msg' doesn't exist"),
        ('"msg/Sphere.msg" DEPENDENCIES nav_msgs', "the passed dependency 'nav_msgs' has not been found before using"),
        ("", "called without any interface files"),
    ],
)
def test_what_is_passed_for_interfaces_is_refused_as_rosidl_refuses_it(interface_package, written, said):
    cmake = interface_package / "CMakeLists.txt"
    call = f"rosidl_generate_interfaces(${{PROJECT_NAME}} {written})"
    cmake.write_text(re.sub(r"rosidl_generate_interfaces\([^)]*\)", lambda _: call, cmake.read_text()))
    code, errors = build_errors(interface_package)
    assert code == 1 and "rosidl_generate_interfaces() " in errors and said.format(at=interface_package) in errors


def test_definition_files_may_lie_in_another_folder_and_packages_are_found_with_others(interface_package):
    cmake = interface_package / "CMakeLists.txt"
    text = cmake.read_text().replace('"msg/Sphere.msg"', '"${CMAKE_CURRENT_SOURCE_DIR}:msg/Sphere.msg"')
    cmake.write_text(text.replace("find_package(geometry_msgs", "find_package(nav_msgs"))  # that finds geometry_msgs, too
    code, errors = build_errors(interface_package)
    assert code == 0, errors
    prefix = interface_package.parent.parent / "install" / "s4_custom_interface"
    assert (prefix / "share/s4_custom_interface/msg/Sphere.msg").is_file()
