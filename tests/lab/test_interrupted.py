"""What a cell shows after the stop button: the student's own lines, and one that says what was interrupted."""

import pytest
import rclpy
from IPython.core.interactiveshell import InteractiveShell

from coursekit.lab import interrupted

IN_A_CALLBACK = """
def stop():
    raise KeyboardInterrupt
node = rclpy.create_node("ear")
timer = node.create_timer(0.5, stop)
def listen():
    rclpy.spin(node)
listen()
"""
WAITS = "from coursekit.lab.waiting import wait\nwait(30)"
SPINS = "node = rclpy.create_node('ear')\nrclpy.spin(node)"


@pytest.fixture
def shell(session):
    made = InteractiveShell(user_ns={"rclpy": rclpy})
    interrupted.install(made)
    made.run_line_magic("colors", "nocolor")
    session.clock.call_at(session.clock.steady() + 10**9, session.interrupt_all)
    rclpy.init()
    yield made
    rclpy.try_shutdown()


def shown_by(shell, capsys, cell):
    """What a cell prints that ends with an interrupt."""
    assert isinstance(shell.run_cell(cell).error_in_exec, KeyboardInterrupt)
    return capsys.readouterr().out


@pytest.mark.parametrize(("cell", "call"), [(WAITS, "wait(30)"), (SPINS, "rclpy.spin(node)")])
def test_the_line_of_the_cell_is_shown_and_named_and_nothing_below_it(shell, capsys, cell, call):
    shown = shown_by(shell, capsys, cell)
    assert f"----> 2 {call}" in shown
    assert shown.splitlines()[-1] == (
        f"KeyboardInterrupt: `{call}` was interrupted. To see all of the calls inside: %tb"
    )
    assert "coursekit" not in shown.replace(WAITS.partition("\n")[0], "") and "interactiveshell.py" not in shown


def test_a_callback_of_the_student_is_shown_as_well(shell, capsys):
    shown = shown_by(shell, capsys, IN_A_CALLBACK)
    assert [line for line in shown.splitlines() if line.startswith("---->")] == [
        "----> 7 listen()", "----> 6     rclpy.spin(node)", "----> 2     raise KeyboardInterrupt",
    ]  # fmt: skip


def test_the_full_traceback_is_kept_for_tb(shell, capsys):
    shown_by(shell, capsys, SPINS)
    shell.run_cell("%tb")
    assert "executors.py" in capsys.readouterr().out


def test_an_interrupt_outside_of_the_course_is_shown_as_ever(shell, capsys):
    shown = shown_by(shell, capsys, "import json\nclass Text(str):\n    def startswith(self, *_): raise KeyboardInterrupt\n"
                     "json.loads(Text('1'))")  # fmt: skip
    assert "decoder" in shown or "json" in shown
    assert "was interrupted" not in shown
