"""Runs of launch tests: parameters, marks, and what tests are given."""

from __future__ import annotations

import signal
import time
import unittest

import launch_testing
import pytest
from launch import LaunchDescription
from launch.actions import EmitEvent, ExecuteProcess, RegisterEventHandler, TimerAction
from launch.events import matches_action
from launch.events.process import SignalProcess
from launch_ros.actions import Node
from launch_testing.actions import GTest, ReadyToTest
from launch_testing.event_handlers import StdoutReadyListener
from launch_testing.loader import LoadTestsFromPythonModule
from launch_testing.markers import keep_alive, retry_on_failure
from launch_testing.test_runner import LaunchTestRunner
from launch_testing.util import KeepAliveProc

from tests.needs import posix


def talker() -> Node:
    return Node(package="demo_nodes_py", executable="talker", name="t")


def succeeded(results) -> dict[str, bool]:
    return {name: result.wasSuccessful() for name, result in results.items()}


def test_a_parametrized_description_is_launched_once_for_each_value(results) -> None:
    @launch_testing.parametrize("number", [1, 2, 3])
    def describe(number):
        return LaunchDescription([talker(), ReadyToTest()])

    class Beside(unittest.TestCase):
        def test_not_two(self, number, proc_output):
            proc_output.assertWaitFor("Hello World: 0")
            assert number != 2

    @launch_testing.post_shutdown_test()
    class After(unittest.TestCase):
        def test_not_three(self, number):
            assert number != 3

    result_by_run = results(describe, Beside, After)
    assert succeeded(result_by_run) == {"launch_tests[1]": True, "launch_tests[2]": False, "launch_tests[3]": False}
    assert [case.id().split(".")[-1] for case in result_by_run["launch_tests[2]"].testCases] == [
        "test_not_two[2]",
        "test_not_three[2]",
    ]


def test_a_description_gets_the_parameters_that_it_takes_and_no_others() -> None:
    from types import SimpleNamespace

    @launch_testing.parametrize("other", [1])
    def describe(number):
        raise AssertionError

    for function, reason in ((describe, "matching prametrized argument 'other'"), (lambda more: 1, "extra argument 'more'")):
        module = SimpleNamespace(generate_test_description=function)
        with pytest.raises(Exception, match=reason):
            LaunchTestRunner(LoadTestsFromPythonModule(module)).validate()  # type: ignore[arg-type]


def test_a_launch_is_kept_alive_without_processes_when_it_is_marked(results) -> None:
    class Beside(unittest.TestCase):
        def test_sleeps(self):
            time.sleep(5.0)

    def describe():
        return LaunchDescription([ReadyToTest()])

    assert succeeded(results(describe, Beside)) == {"launch_tests": False}
    assert succeeded(results(keep_alive(describe), Beside)) == {"launch_tests": True}


def test_a_failing_test_is_tried_again_and_sub_tests_count(results, session) -> None:
    class Beside(unittest.TestCase):
        tries: list[str] = []

        @retry_on_failure(times=3, delay=2.0)
        def test_third(self):
            self.tries.append("third")
            assert self.tries.count("third") == 3

        @retry_on_failure(times=2)
        def test_sub(self):
            self.tries.append("sub")
            with self.subTest("inner"):
                assert self.tries.count("sub") == 2

        @retry_on_failure(times=2)
        def test_never(self):
            self.tries.append("never")
            raise AssertionError

    result = results(lambda: LaunchDescription([talker(), ReadyToTest()]), Beside)["launch_tests"]
    assert [case._testMethodName for case, _ in result.failures] == ["test_never"] and not result.errors
    assert [Beside.tries.count(name) for name in ("third", "sub", "never")] == [3, 2, 2]
    assert session.clock.steady() >= 4e9


def test_processes_start_and_end_while_tests_wait(results) -> None:
    def describe():
        first, late = talker(), talker()
        end = EmitEvent(event=SignalProcess(signal_number=signal.SIGINT, process_matcher=matches_action(first)))
        timers = TimerAction(period=10.0, actions=[end]), TimerAction(period=5.0, actions=[late])
        return LaunchDescription([first, KeepAliveProc(), *timers, ReadyToTest()]), {"first": first, "late": late}

    class Beside(unittest.TestCase):
        def test_1_start(self, proc_info, late):
            with self.assertRaisesRegex(AssertionError, "Timed out waiting for process .* to start"):
                proc_info.assertWaitForStartup(late, timeout=1)
            proc_info.assertWaitForStartup(late)

        def test_2_end(self, proc_info, first):
            with self.assertRaisesRegex(AssertionError, "Timed out waiting for process .* to finish"):
                proc_info.assertWaitForShutdown(first, timeout=1)
            proc_info.assertWaitForShutdown(first)

        def test_3_names(self, proc_info, proc_output):
            self.assertEqual(proc_info["talker-1"].returncode, 0)
            self.assertIn("talker-1", proc_output.process_names())

    assert succeeded(results(describe, Beside)) == {"launch_tests": True}


@posix("there is no sh")
def test_a_text_says_that_tests_may_begin(results) -> None:
    def describe():
        echo = ExecuteProcess(cmd=["sh", "-c", "sleep 0.1; echo it is ready; sleep 100"])
        listener = StdoutReadyListener(target_action=echo, ready_txt="is ready", actions=[ReadyToTest()])
        return LaunchDescription([echo, RegisterEventHandler(listener)])

    class Beside(unittest.TestCase):
        def test_ready(self, proc_output):
            launch_testing.asserts.assertInStdout(proc_output, "it is ready", "sh")

    assert succeeded(results(describe, Beside)) == {"launch_tests": True}


@posix("there is no cat, and a program that is ended has no code -9")
def test_a_test_program_is_killed_when_it_takes_too_long(results) -> None:
    def describe():
        slow, quick = GTest(path="cat", timeout=1.0), GTest(path="true", timeout=1.0)
        return LaunchDescription([slow, quick, KeepAliveProc(), ReadyToTest()]), {"slow": slow, "quick": quick}

    class Beside(unittest.TestCase):
        def test_codes(self, proc_info, slow, quick):
            for action in (slow, quick):
                proc_info.assertWaitForShutdown(action)
            self.assertEqual((slow.return_code, quick.return_code, slow.timeout), (-9, 0, 1.0))

    assert succeeded(results(describe, Beside)) == {"launch_tests": True}


def test_attributes_are_given_with_a_word_that_arguments_are_better(results) -> None:
    class Beside(unittest.TestCase):
        def test_attributes(self):
            with self.assertWarnsRegex(UserWarning, "add proc_info to the test method argument list"):
                self.proc_info.assertWaitForStartup("talker")
            self.proc_output.assertWaitFor("Hello World: 0")

    assert succeeded(results(lambda: LaunchDescription([talker(), ReadyToTest()]), Beside)) == {"launch_tests": True}
