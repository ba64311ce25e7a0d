"""What a verdict says beside what a program died of."""

from types import SimpleNamespace

import pytest

from coursekit.grade import checking
from coursekit.grade.checking import judge_work
from coursekit.grade.exception_advice import DIED, NOT_LOADED
from coursekit.grade.exercise import Exercise
from coursekit.grade.outputs import last_words, said, wrote
from coursekit.grade.verdict import CheckFailed, Wrong

TRACE = 'Traceback (most recent call last):\n  File "/ws/my_node.py", line 9, in main\n    spin()\nNameError: no spin\n'
UNLOADED = """Traceback (most recent call last):
  File "/ws/install/a/lib/a/a_exe", line 33, in <module>
    sys.exit(load_entry_point('a==0.0.0', 'console_scripts', 'a_exe')())
  File "/ws/install/a/lib/a/a_exe", line 25, in importlib_load_entry_point
    return next(matches).load()
  File "/usr/lib/python3.11/importlib/metadata/__init__.py", line 202, in load
    module = import_module(match.group('module'))
"""


def close(work):
    """A check that guesses why nothing came."""
    work.try_out("run a a_exe")
    raise Wrong("an answer", "none", "Is the topic's name right?", hint=0)


def close_with_last_words(work):
    """A check that tells the program's last words itself, and guesses."""
    seen = work.try_out("run a a_exe")
    raise Wrong("an answer", f"none; it said: {last_words(said(seen))}", "Is the topic's name right?", hint=0)


def close_with_the_output(work):
    """A check that shows the end of what the program wrote."""
    raise Wrong("an answer", wrote(work.try_out("run a a_exe")))


def verdict(output, judge=close):
    """The verdict on a program that said this, at the third try."""
    work = SimpleNamespace(try_out=lambda *commands: SimpleNamespace(outputs=[output]))
    return judge_work(Exercise("own.q1", "Close it", 2, ("Which topic?",), judge), work, 3)


def test_where_the_program_died_the_check_does_not_guess():
    said = verdict(TRACE)
    assert "NameError: no spin" in said.got and (said.cause, said.hint) == (DIED, "")


def test_nor_where_the_check_tells_the_exception_itself():
    said = verdict(TRACE, close_with_last_words)
    assert said.got == "none; it said: NameError: no spin (line 9 of my_node.py: spin())"
    assert (said.cause, said.hint) == (DIED, "")


@pytest.mark.parametrize("error", ["StopIteration", "ModuleNotFoundError: No module named 'a.b'"])
def test_of_an_executable_that_loads_nothing_the_cells_to_run_are_told(error):
    said = verdict(UNLOADED + f"{error}\n")
    assert error in said.got and (said.cause, said.hint) == (NOT_LOADED, "")


def test_of_a_service_s_callback_that_gives_nothing_back_the_return_is_told():
    said = verdict(TRACE.replace("NameError: no spin", "TypeError"))
    assert "return response" in said.cause


@pytest.mark.parametrize(
    "error",
    [
        "AttributeError: 'NoneType' object has no attribute 'successful'",
        "rclpy.exceptions.InvalidParameterValueException: ('Invalid parameter value (1) for parameter. "
        "Reason: Callback returned an invalid type', 'a')",
    ],
)
def test_of_a_callback_that_judges_and_gives_no_result_back_the_result_is_told(error):
    said = verdict(TRACE.replace("NameError: no spin", error))
    assert "SetParametersResult" in said.cause


def test_a_launch_file_s_own_error_is_told_with_a_short_path():
    line = "[ERROR] [launch]: Caught exception in launch (see debug for traceback): '/home/a/ws/install/a/b.py' is odd\n"
    said = verdict(line, close_with_last_words)
    assert (said.got, said.cause) == ("none; it said: 'install/a/b.py' is odd", DIED)


def test_the_student_s_line_is_told_not_that_of_a_message_s_class():
    inner = '  File "<std_msgs/msg/Float64>", line 36, in data\n    assert isinstance(value, float)\n'
    told = verdict(TRACE.replace("NameError", inner + "NameError")).got
    assert told == "your program raised NameError: no spin (line 9 of my_node.py: spin()); none"


def test_of_an_output_that_is_the_traceback_only_the_exception_is_told():
    told = verdict(TRACE, close_with_the_output).got
    assert told == "your program raised NameError: no spin (line 9 of my_node.py: spin())"


def test_where_it_lived_the_guess_and_the_hint_are_given():
    said = verdict("nothing\n")
    assert (said.got, said.cause, said.hint) == ("none", "Is the topic's name right?", "Which topic?")


def test_a_check_that_is_stopped_says_so_in_one_line(tmp_path, monkeypatch):
    def endless(*_):
        raise KeyboardInterrupt

    monkeypatch.setenv("COURSEKIT_WORKSPACE", str(tmp_path / "ros2_ws"))
    monkeypatch.setattr(checking, "judge_work", endless)
    with pytest.raises(CheckFailed) as caught:
        checking.check("ch08.q3")
    assert caught.value._render_traceback_() == [
        "ch08.q3 was stopped, so it is not judged. Is there a loop that never ends?"
    ]
