"""What a cell that is run again says of what it replaced."""

import sys
from types import SimpleNamespace

import pytest

from coursekit.lab.cells import _listed

TALKER = SimpleNamespace(argv=["ros2", "run", "demo_nodes_py", "talker"], name="talker")
LISTENER = SimpleNamespace(argv=["ros2", "run", "demo_nodes_py", "listener"], name="listener")
A, B, C = (SimpleNamespace(full_name=name) for name in ("/a", "/b", "/c"))
CONTEXT = SimpleNamespace(try_shutdown=None)


def test_a_program_is_told_as_it_was_typed():
    assert _listed([TALKER]) == "process `ros2 run demo_nodes_py talker`"


def test_a_program_that_the_course_started_by_its_path_is_told_by_its_name():
    started = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "robot"]
    assert _listed([SimpleNamespace(argv=started, name="practice_robot")]) == "process `practice_robot`"


@pytest.mark.parametrize(
    ("things", "told"),
    [
        ([TALKER, LISTENER], "the processes `ros2 run demo_nodes_py talker` and `ros2 run demo_nodes_py listener`"),
        ([TALKER, TALKER], "process `ros2 run demo_nodes_py talker`"),
        ([A, CONTEXT], "node /a and rclpy.init()"),
        ([CONTEXT, C, A, B, A], "the nodes /c, /a and /b and rclpy.init()"),
        ([A, TALKER], "process `ros2 run demo_nodes_py talker` and node /a"),
    ],
)
def test_each_kind_is_said_once(things, told):
    assert _listed(things) == told
