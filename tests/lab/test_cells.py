"""What a cell that is run again says of what it replaced."""

import sys
from types import SimpleNamespace

from coursekit.lab.cells import _describe


def test_a_program_is_told_as_it_was_typed():
    typed = ["ros2", "run", "demo_nodes_py", "talker"]
    assert _describe(SimpleNamespace(argv=typed, name="talker")) == "process ros2 run demo_nodes_py talker"


def test_a_program_that_the_course_started_by_its_path_is_told_by_its_name():
    started = [sys.executable, "-m", "coursekit.cli.coursekit", "network", "robot"]
    assert _describe(SimpleNamespace(argv=started, name="practice_robot")) == "process practice_robot"
