"""The likely cause that a check gives is that of the fault at hand, not of the exercise's usual one."""


import pytest

from coursekit.grade.checking import judge_work
from coursekit.grade.exercise import Exercise
from coursekit.grade.outputs import last_words
from coursekit.grade.plan import Seen
from coursekit.grade.sandbox_facts import BuildFacts
from coursekit.grade.verdict import Wrong
from coursekit.grade.work import Work


def trace(error, line):
    where = '  File "/ws/install/p/lib/python3.10/site-packages/s7_py_client_robot/stages.py", line 4, in next_step'
    return f"Traceback (most recent call last):\n{where}\n    {line}\n{error}\n"


@pytest.mark.parametrize(
    ("error", "line", "cause"),
    [
        ("NotImplementedError", "raise NotImplementedError()", "write your code where that line stands"),
        ("TypeError: cannot unpack non-iterable float object", "x, y = step()", "what should your function return?"),
        ("ValueError: not enough values to unpack (expected 4, got 3)", "a, b, c, d = step()", "your function return?"),
        (
            "AttributeError: 'NoneType' object has no attribute 'sum'", "print(future.result().sum)",
            "spin until the future is complete",
        ),
        ("AssertionError: The 'a' field must be of type 'int'", "ask(sys.argv[1])", "takes exactly its type"),
        ("AttributeError: 'Vera' object has no attribute '_logger'", "self.get_logger()", "super().__init__"),
        ("KeyError: 3", "poses[3]", "mend the line that it names"),
    ],
)
def test_what_a_program_died_of_comes_before_the_check_s_guess_also_where_the_check_has_told_it(error, line, cause):
    class Tried(Work):
        def try_out(self, *commands, **plan):
            return Seen(outputs=[trace(error, line)], exit_codes=[1])

    def judge_trial(work):
        output = work.try_out("run p p_exe").outputs[0]
        raise Wrong("reports", f"none; it said: {last_words(output)}", "Was it built?", hint=0)

    verdict = judge_work(Exercise("ch99.q1", "Try", 1, ("a hint",), judge_trial), Tried({}, None), 3)
    assert verdict.got.count(f"{error} (line 4") == 1 and cause in verdict.cause and not verdict.hint


def test_after_a_failed_build_its_output_is_named(tmp_path, monkeypatch):
    class Failed(Work):
        def _read(self, what, **arguments):
            return BuildFacts(True, "the last build of p failed, so install/ holds an older one")

    with pytest.raises(Wrong) as caught:
        Failed({}, tmp_path).built("p")
    assert caught.value.cause == "The build's output says why. Mend that, then run: %colcon build --packages-select p"


@pytest.mark.parametrize(
    ("command", "output", "cause"),
    [
        ("run p my_exe --ros-args -p x:=1", "No executable found\n", "p has no executable my_exe. Run the cell that"),
        ("run p my_exe", "I say: No executable found\n", "Does it start?"),
        (
            "launch p l.py",
            "[ERROR] [launch]: Caught exception in launch (see debug for traceback): executable 'my_exe' not found on the "
            "libexec directory '/ws/install/p/lib/p' \n",
            "Run the cell that adds it to setup.py",
        ),
    ],
)
def test_an_executable_that_is_not_there_is_told_as_such(command, output, cause):
    class Tried(Work):
        def try_out(self, *commands, **plan):
            return Seen(outputs=[output], exit_codes=[1])

    def judge_trial(work):
        work.try_out(command)
        raise Wrong("a node", "none", "Does it start?", hint=0)

    assert judge_work(Exercise("ch99.q1", "Try", 1, ("a hint",), judge_trial), Tried({}, None), 3).cause.startswith(cause)
