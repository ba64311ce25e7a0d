"""The command `launch_test`: tests beside a launch and after it, what they get, and how they may end."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

from tests.needs import posix

TALKER = """
def generate_test_description():
    node = talker()
    return LaunchDescription([DeclareLaunchArgument("word", default_value="x"), node, ReadyToTest()]), {"node": node}
"""


def test_tests_beside_a_launch_see_what_it_prints_and_those_after_it_how_it_ended(launch_test) -> None:
    outcome = launch_test(
        TALKER
        + """
class TestBeside(unittest.TestCase):
    def test_output(self, proc_output, node):
        before = time.time()
        proc_output.assertWaitFor("Hello World: 4", process=node)
        self.assertAlmostEqual(time.time() - before, 5.0)

@launch_testing.post_shutdown_test()
class TestAfter(unittest.TestCase):
    def test_end(self, proc_info, proc_output, node):
        launch_testing.asserts.assertExitCodes(proc_info, process=node)
        with self.assertRaisesRegex(AssertionError, "Did not find 'Hello World: 5' in output .*: talker-1"):
            launch_testing.asserts.assertInStderr(proc_output, "Hello World: 5", "talker")
"""
    )
    assert outcome.code == 0, outcome.text
    assert outcome.cases == {"test_output": [], "test_end": []}
    assert outcome.report.attrib == {
        "name": "some_launch_test.some_launch_test",
        "tests": "2",
        "failures": "0",
        "errors": "0",
    }


def test_launch_arguments_reach_the_launch_and_its_tests(launch_test) -> None:
    text = """
def generate_test_description():
    word = LaunchConfiguration("word")
    echo = ExecuteProcess(cmd=["echo", word])
    keep = launch_testing.util.KeepAliveProc()
    return LaunchDescription([DeclareLaunchArgument("word", description="what"), echo, keep, ReadyToTest()])

class TestWord(unittest.TestCase):
    def test_word(self, proc_output, test_args):
        proc_output.assertWaitFor(test_args["word"], process="echo", stream="stdout")
        self.assertEqual(test_args["word"], "two")
"""
    assert launch_test(text, "word:=one", "word:=two").code == 0
    shown = launch_test(text, "--show-args")
    assert shown.code is None and "'word':\n        what" in shown.text
    with pytest.raises(RuntimeError, match="malformed launch argument 'word=two'"):
        launch_test(text, "word=two")


def test_what_fails_is_reported_and_the_code_is_1(launch_test) -> None:
    outcome = launch_test(
        TALKER
        + """
class TestBeside(unittest.TestCase):
    def test_fails(self):
        assert 1 == 2, "of course"

    def test_raises(self):
        raise ValueError("no")

    @unittest.skip("not today")
    def test_skipped(self):
        pass
"""
    )
    assert outcome.code == 1
    assert outcome.cases == {"test_fails": ["failure"], "test_raises": ["error"], "test_skipped": ["skipped"]}
    assert "AssertionError: of course" in outcome.report.find(".//failure").attrib["message"]


@posix("there is no sh")
def test_a_launch_that_ends_before_its_tests_fails_all_of_them(launch_test) -> None:
    outcome = launch_test(
        """
def generate_test_description():
    return LaunchDescription([ExecuteProcess(cmd=["sh", "-c", "echo oh no; exit 3"]), ReadyToTest()])

class TestBeside(unittest.TestCase):
    def test_sleeps(self):
        time.sleep(20)

@launch_testing.post_shutdown_test()
class TestAfter(unittest.TestCase):
    def test_after(self):
        pass
"""
    )
    assert outcome.code == 1
    assert outcome.cases == {"test_sleeps": ["failure"], "test_after": ["failure"]}
    assert "Process 'sh-1' exited with 3\n##### 'sh-1' output #####\noh no\n" in outcome.text
    assert "Launch stopped before the active tests finished." in outcome.report.find(".//failure").attrib["message"]


def test_a_launch_that_is_never_ready_is_given_up_after_15_seconds(launch_test, session) -> None:
    outcome = launch_test(
        """
def generate_test_description():
    return LaunchDescription([talker(), TimerAction(period=60.0, actions=[ReadyToTest()])])

class TestBeside(unittest.TestCase):
    def test_never(self):
        pass
"""
    )
    assert outcome.code == 1 and outcome.cases == {"test_never": ["failure"]}
    assert "Timed out waiting for processes to start up" in outcome.text
    assert 15e9 <= session.clock.steady() < 20e9


def test_without_an_action_that_says_ready_there_is_an_error(launch_test) -> None:
    with pytest.raises(Exception, match=r"containing a ReadyToTest action: add launch_testing.actions.ReadyToTest\(\)"):
        launch_test("def generate_test_description():\n    return LaunchDescription([])\n")


def test_the_command_says_what_is_wrong_with_code_2(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "launch_testing.launch_test", str(tmp_path / "no_file.py")]
    result = subprocess.run(command, capture_output=True, encoding="utf-8", check=False)
    assert result.returncode == 2 and f"error: Test file '{tmp_path / 'no_file.py'}' does not exist" in result.stderr
