"""Commands that tutorials type for windows: rviz2 runs its node, rqt's say what stands in."""

import sys

import pytest

from coursekit import wiring
from coursekit.cli import ros2, window_commands
from coursekit.cli.parser import run
from coursekit.processes.session import Session


def test_rviz2_is_run_with_its_words(monkeypatch):
    ran = []
    monkeypatch.setattr(ros2, "main", lambda argv: ran.append(argv) or 0)
    monkeypatch.setattr(sys, "argv", ["/somewhere/bin/rviz2", "-d", "turtle.rviz"])
    assert window_commands.run_node() == 0
    assert ran == [["run", "rviz2", "rviz2", "-d", "turtle.rviz"]]


def test_a_launch_file_starts_rviz2_by_its_name(tmp_path):
    path = tmp_path / "view.launch.py"
    path.write_text(
        "from launch import LaunchDescription\n"
        "from launch.actions import ExecuteProcess\n"
        "def generate_launch_description():\n"
        "    return LaunchDescription([ExecuteProcess(cmd=['rviz2'], output='screen')])\n"
    )
    with Session(virtual=True).use() as session:
        launch = session.start(lambda: run(["launch", str(path)]), name="ros2")
        session.clock.sleep(2)
        assert "No notebook shows this window" in launch.output
        launch.interrupt()
        assert launch.wait(10) == 0


def test_the_node_of_a_launch_file_is_one_process_and_not_two():
    with Session(virtual=True).use() as session:
        launch = session.start(lambda: run(["launch", "urdf_tutorial", "display.launch.py", "gui:=false"]), name="ros2")
        session.clock.sleep(1)
        assert [process.name for process in session.processes].count("rviz2") == 1
        launch.interrupt()
        assert launch.wait(10) == 0


@pytest.mark.parametrize(
    ("command", "package"),
    [("rqt", "rqt_gui"), ("rqt_graph", "rqt_graph"), ("rqt_console", "rqt_console"), ("rqt_plot", "rqt_plot")],
)
def test_a_window_of_rqt_is_run_by_its_command(monkeypatch, command, package):
    ran = []
    monkeypatch.setattr(ros2, "main", lambda argv: ran.append(argv) or 0)
    monkeypatch.setattr(sys, "argv", [f"/somewhere/bin/{command}", "--force-discover"])
    assert window_commands.run_node() == 0 and ran == [["run", package, package, "--force-discover"]]


@pytest.mark.parametrize(
    ("command", "instead"), [("rqt", "ros2 service call"), ("rqt_graph", "ros2 node info"), ("rqt_console", "/rosout")]
)
def test_without_a_notebook_a_window_of_rqt_says_what_to_type(command, instead):
    with Session(virtual=True).use() as session:
        carry_out = wiring.command(command)
        process = session.start(lambda: carry_out([]), name=command)
        assert process.wait(5) == 1
        assert process.output.startswith("No notebook shows this window. Here: ") and instead in process.output
