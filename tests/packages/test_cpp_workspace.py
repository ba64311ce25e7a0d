"""A workspace of packages in C++, built by colcon with real CMake, and run among Python's programs on the virtual clock."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import compiler_or_skip

pytestmark = [pytest.mark.slow, pytest.mark.timeout(300)]
SOURCES = Path(__file__).parent.parent / "fixtures" / "cpp_ws" / "src"
BIN = Path(sys.executable).parent
ENV = {k: v for k, v in os.environ.items() if k not in ("AMENT_PREFIX_PATH", "COLCON_PREFIX_PATH", "PYTHONPATH")}
ENV |= {"PATH": f"{BIN}{os.pathsep}{ENV['PATH']}", "COURSEKIT_TIME": "virtual"}


def colcon(folder, *words, env=ENV):
    command = [str(BIN / "colcon"), "--log-base", "log", *words]
    return subprocess.run(command, cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)


def sourced(folder, command):
    line = f"source install/setup.bash && {command}"
    return subprocess.run(["bash", "-c", line], cwd=folder, env=ENV, capture_output=True, encoding="utf-8", check=False)


def scripted(folder, text):
    """Run Python's text where the workspace is sourced."""
    return sourced(folder, f"'{sys.executable}' - <<'END'\n{text}END")


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    compiler_or_skip()
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
    said = scripted(workspace, TOGETHER)
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
    done = scripted(workspace, text)
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


IN_A_CONTAINER = """
from coursekit.cli.parser import run

def ros2(*words):
    command = session.start(lambda: run(["component", *words]), name="ros2", argv=words)
    command.wait(10.0)

box = session.launch(make_process(session, find("rclcpp_components", "component_container"), name="box"))
session.clock.sleep(0.2)
for name in ("left", "right", "rear"):
    ros2("load", "/ComponentManager", "k_parts", "k_parts::Winch", "-n", name)
ros2("unload", "/ComponentManager", "1")
unloaded = box.output
box.interrupt()
print(box.wait(10.0), "signal" in unloaded, box.output.count("signal_handler(signum=2)"))
print(*(line.split("Load Library: ")[1] for line in unloaded.splitlines() if "Load" in line))
"""


def test_a_container_of_compiled_components_tells_of_ctrl_c_once_and_names_their_library(workspace):
    said = alone(workspace, IN_A_CONTAINER).splitlines()
    assert said[0] == "0 False 1", said
    assert [Path(word).name for word in said[1].split()] == ["libwinch.so"], said


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


def test_tests_in_cpp_are_built_and_run_or_named(workspace):
    tested = colcon(workspace, "test", "--packages-select", "k_route")
    assert tested.returncode == 0, tested.stdout + tested.stderr
    if not os.path.isfile("/usr/include/gtest/gtest.h"):
        assert "Skipped tests of k_route: test_route, test_with_node" in tested.stdout
        assert "sudo apt install libgtest-dev libgmock-dev" in tested.stdout + tested.stderr
        return
    assert colcon(workspace, "test-result").stdout == "Summary: 4 tests, 0 errors, 0 failures, 0 skipped\n"
    source = workspace / "src" / "k_route" / "test" / "test_route.cpp"
    right = source.read_text(encoding="utf-8")
    source.write_text(right + "TEST(Route, fails) {EXPECT_EQ(1, 2);}\n", encoding="utf-8")
    colcon(workspace, "test", "--packages-select", "k_route")
    source.write_text(right, encoding="utf-8")
    told = colcon(workspace, "test-result", "--verbose").stdout
    assert "Summary: 5 tests, 0 errors, 2 failures, 0 skipped" in told and "test_route.cpp" in told
