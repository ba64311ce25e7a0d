"""Launch tests in pytest: what is collected, how it is shown, and that other runs are left alone."""

from __future__ import annotations

import pytest

MARKED = """
@pytest.mark.{mark}
def generate_test_description():
    return LaunchDescription([DeclareLaunchArgument("word", default_value="x"), talker(), ReadyToTest()])

class TestBeside(unittest.TestCase):
    def test_word(self, proc_output, test_args):
        proc_output.assertWaitFor("Hello World: 1")
        self.assertEqual(test_args.get("word", "x"), "x")
"""


@pytest.mark.parametrize("mark", ["launch_test", "rostest"])
def test_a_marked_file_is_one_test(run_pytest, mark: str) -> None:
    result = run_pytest({"a_launch_test.py": MARKED.format(mark=mark)}, "-m", mark, "-W", "error::pytest.PytestWarning")
    assert result.returncode == 0, result.stdout
    assert "a_launch_test.py::a_launch_test PASSED" in result.stdout and "1 passed" in result.stdout


def test_arguments_come_from_the_command_line_and_failures_are_shown_by_test(run_pytest) -> None:
    text = MARKED.format(mark="launch_test")
    result = run_pytest({"test_it.py": text}, "--launch-args", "word:=y", "-p", "no:xdist")
    assert result.returncode == 1
    assert "FAIL: test_it.TestBeside.test_word\n---" in result.stdout and "AssertionError: 'y' != 'x'" in result.stdout


def test_a_file_without_the_mark_is_as_any_other(run_pytest) -> None:
    text = MARKED.format(mark="launch_test").replace("@pytest.mark.launch_test", "")
    result = run_pytest({"test_it.py": text + "\ndef test_plain():\n    pass\n"}, "-k", "plain")
    assert result.returncode == 0 and "test_it.py::test_plain PASSED" in result.stdout


def test_a_file_that_cannot_be_imported_is_an_error_as_any_other(run_pytest) -> None:
    result = run_pytest({"test_it.py": "import no_such_module\ndef generate_test_description(): pass\n"})
    assert result.returncode == 2 and "ERROR collecting test_it.py" in result.stdout
    assert "No module named 'no_such_module'" in result.stdout
    result = run_pytest(
        {"test_it.py": "pytest.skip('not here', allow_module_level=True)\ndef generate_test_description(): 1\n"}
    )
    assert "1 skipped" in result.stdout


def test_a_skipped_description_leaves_its_tests_out(run_pytest) -> None:
    text = MARKED.format(mark="launch_test").replace("def generate", "@unittest.skip('no robot')\ndef generate")
    result = run_pytest({"test_it.py": text}, "-s")
    assert result.returncode == 0 and "test_it is skipped: no robot" in result.stdout


def test_runs_without_launch_tests_do_not_import_launch(run_pytest, tmp_path) -> None:
    text = "import sys\ndef test_imports():\n    assert not {'launch', 'rclpy', 'coursekit.core'} & set(sys.modules)\n"
    (tmp_path / "test_plain.py").write_text(text)
    result = run_pytest({}, "test_plain.py")
    assert result.returncode == 0, result.stdout


def test_a_marked_test_may_be_run_again_by_other_plugins(run_pytest) -> None:
    text = MARKED.format(mark="rostest") + "    times = []\n    def test_times(self):\n        self.times.append(1)\n"
    result = run_pytest({"test_it.py": text + "        self.assertEqual(len(self.times), 2)\n"}, "--reruns", "1")
    assert "1 passed, 1 rerun" in result.stdout


@pytest.mark.slow
def test_programs_that_a_test_starts_outside_of_the_session_join_it(run_pytest) -> None:
    text = MARKED.format(mark="rostest") + """
    def test_join(self, proc_output):
        import os, subprocess
        proc_output.assertWaitFor("Hello World: 0")
        command = [os.path.dirname(sys.executable) + "/ros2", "node", "list"]
        self.assertEqual(subprocess.run(command, capture_output=True, text=True).stdout, "/t\\n")
        kept.append(os.environ["ROS_DOMAIN_ID"])

kept = []

@launch_testing.post_shutdown_test()
class TestAfter(unittest.TestCase):
    def test_domain(self):
        self.assertIn(int(kept[0]), range(101))
"""
    result = run_pytest({"test_it.py": text}, clock="")
    assert result.returncode == 0, result.stdout
