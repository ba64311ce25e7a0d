"""One launch with its tests: some run in a thread of their own during the launch, others after its end."""

from __future__ import annotations

import threading
import unittest
from collections.abc import Sequence
from typing import Any

from launch import LaunchDescription, LaunchDescriptionSource, LaunchService
from launch.actions import IncludeLaunchDescription, RegisterEventHandler
from launch.event_handlers import OnProcessExit, OnProcessIO, OnProcessStart
from launch.events.process import ProcessStarted
from launch.launch_description_entity import LaunchDescriptionEntity

from .io_handler import ActiveIoHandler
from .loader import TestRun
from .parse_arguments import parse_launch_arguments
from .proc_info_handler import ActiveProcInfoHandler
from .test_result import TestResult

READY_SECONDS = 15.0
"""The time [s] that a launch may take until its ReadyToTest action."""


class LaunchDied(Exception):
    """The launch ended before its tests did."""


class RunnerWorker:
    """Launches `preamble` and the description of `test_run`, and runs its tests."""

    def __init__(
        self,
        test_run: TestRun,
        preamble: Sequence[LaunchDescriptionEntity],
        launch_file_arguments: Sequence[str],
        debug: bool,
    ) -> None:
        self._test_run = test_run
        self._preamble = preamble
        self._arguments = list(parse_launch_arguments(launch_file_arguments))
        self._service = LaunchService(debug=debug)
        self._ready = threading.Event()
        self._results: TestResult | None = None
        self._failure: BaseException | None = None
        self._proc_info = ActiveProcInfoHandler()
        self._proc_output = ActiveIoHandler()

    def run(self) -> TestResult:
        """Return the results of all tests.

        Raises:
            LaunchDied: when the launch ended too early, or never became ready.
        """
        description, context = self._test_run.normalized_test_description(ready_fn=self._ready.set)
        self._bind({**context, **self._test_run.param_args})
        self._service.include_launch_description(self._whole(description))
        testing = threading.Thread(target=self._run_test, name="test_runner_thread", daemon=True)
        testing.start()
        self._service.run(shutdown_when_idle=not self._test_run.markers.get("keep_alive", False))
        self._ready.set()  # a thread that still waits for it need not wait any longer
        if self._failure is not None:
            raise self._failure
        if self._results is None:
            print("Processes under test stopped before tests completed")
            self._print_failed_processes()
            raise LaunchDied
        self._results.append(_run_tests(self._test_run.post_shutdown_tests))
        return self._results

    def _bind(self, context: dict[str, Any]) -> None:
        """Bind tests to the objects that they name. After the launch, these are handlers that do not wait."""
        both = {"test_args": dict(self._arguments)}
        beside = {
            "launch_service": self._service,
            "proc_info": self._proc_info,
            "proc_output": self._proc_output,
            **both,
        }
        after = {
            "proc_info": self._proc_info._proc_info_handler,
            "proc_output": self._proc_output._io_handler,
            **both,
        }
        self._test_run.bind(self._test_run.pre_shutdown_tests, beside, {**context, **beside})
        self._test_run.bind(self._test_run.post_shutdown_tests, after, {**context, **after})

    def _whole(self, description: LaunchDescription) -> LaunchDescription:
        keep = self._proc_output.append
        handlers = (
            OnProcessStart(on_start=lambda event, _: self._proc_info.append(event)),
            OnProcessStart(on_start=lambda event, _: self._proc_output.track(event.process_name)),
            OnProcessExit(on_exit=lambda event, _: self._proc_info.append(event)),
            OnProcessIO(on_stdout=keep, on_stderr=keep),
        )
        return LaunchDescription(
            [
                *self._preamble,
                *(RegisterEventHandler(handler) for handler in handlers),
                IncludeLaunchDescription(LaunchDescriptionSource(description), launch_arguments=self._arguments),
            ]
        )

    def _run_test(self) -> None:
        """Run the tests as soon as the launch is ready, then shut the launch down."""
        try:
            if not self._ready.wait(READY_SECONDS):
                print("Timed out waiting for processes to start up")
            elif self._service.event_loop is not None:
                self._results = _run_tests(self._test_run.pre_shutdown_tests)
        except BaseException as error:
            self._failure = error
        finally:
            _ = self._service.shutdown()

    def _print_failed_processes(self) -> None:
        """Print the exit codes and the output of failed processes, which may be the reason."""
        for info in self._proc_info:
            if isinstance(info, ProcessStarted) or info.returncode == 0:
                continue
            print(f"Process '{info.process_name}' exited with {info.returncode}")
            print(f"##### '{info.process_name}' output #####")
            for piece in self._proc_output[info.process_name]:
                print(piece.text.decode())
            print("#" * (len(info.process_name) + 21))


def _run_tests(tests: Any) -> TestResult:
    result = unittest.TextTestRunner(verbosity=2, resultclass=TestResult).run(tests)
    assert isinstance(result, TestResult)
    return result
