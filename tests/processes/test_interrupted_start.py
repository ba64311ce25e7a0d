"""Ctrl-C while a program is still starting: ours ends without a word, a student's shows where it was."""

from pathlib import Path

import pytest

import coursekit
from coursekit.processes.session import Session

OURS = Path(coursekit.__file__).parent / "nodes" / "robots" / "some_node.py"


@pytest.mark.parametrize(("file", "lines"), [(OURS, 0), (Path("/home/me/my_node.py"), 4)])
def test_a_traceback_is_shown_of_the_student_s_programs_only(file, lines):
    space = {}
    exec(compile("def main():\n    raise KeyboardInterrupt\n", str(file), "exec"), space)
    with Session(virtual=True).use() as session:
        process = session.start(space["main"], name="node")
        process.wait()
    assert process.exit_code == -2
    assert len(process.output.splitlines()) <= lines
    assert ("my_node.py" in process.output) == (lines > 0)


def test_other_errors_of_our_programs_are_shown():
    space = {}
    exec(compile("def main():\n    raise ValueError('wrong')\n", str(OURS), "exec"), space)
    with Session(virtual=True).use() as session:
        process = session.start(space["main"], name="node")
        process.wait()
    assert "ValueError: wrong" in process.output
