"""Tests a program while it runs, and what it wrote once it has ended: `launch_test good_proc_launch_test.py`."""

import sys
import unittest
from pathlib import Path

import launch_testing.actions
import launch_testing.asserts
import pytest
from ament_index_python import get_package_prefix
from launch import LaunchDescription
from launch.actions import ExecuteProcess

PROGRAM = Path(get_package_prefix("launch_testing"), "lib", "launch_testing", "good_proc")


@pytest.mark.launch_test
def generate_test_description():
    """The program, and a name under which tests get it."""
    counter = ExecuteProcess(cmd=[sys.executable, str(PROGRAM)])
    return LaunchDescription([counter, launch_testing.actions.ReadyToTest()]), {"counter": counter}


class TestWhileItRuns(unittest.TestCase):
    """Runs beside the program."""

    def test_count_to_four(self, proc_output):
        """It counts."""
        for number in range(1, 5):
            proc_output.assertWaitFor(f"Loop {number}", timeout=10, stream="stdout")


@launch_testing.post_shutdown_test()
class TestOnceItHasEnded(unittest.TestCase):
    """Runs when the launch is over."""

    def test_exit_code(self, proc_info):
        """It ended as it should."""
        launch_testing.asserts.assertExitCodes(proc_info)

    def test_full_output(self, proc_output, counter):
        """Its output came in order."""
        with launch_testing.asserts.assertSequentialStdout(proc_output, counter) as checker:
            checker.assertInStdout("Starting Up")
            for number in range(4):
                checker.assertInStdout(f"Loop {number}")
            checker.assertInStdout("Shutting Down")
