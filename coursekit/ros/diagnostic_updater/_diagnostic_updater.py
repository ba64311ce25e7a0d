"""Diagnostic tasks, and the updater that runs them periodically."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus
from rclpy.node import Node

from ._diagnostic_status_wrapper import DiagnosticStatusWrapper


class DiagnosticTask:
    """A task that reports a status: derive from it and implement `run`."""

    def __init__(self, name: str) -> None:
        self.name = name

    def getName(self) -> str:
        """The name of the task."""
        return self.name

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Fill a status and return it."""
        raise NotImplementedError


class FunctionDiagnosticTask(DiagnosticTask):
    """A task that is a function of the status."""

    def __init__(self, name: str, fn: Callable[[DiagnosticStatusWrapper], Any]) -> None:
        super().__init__(name)
        self.fn = fn

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Call the function."""
        status: DiagnosticStatusWrapper = self.fn(stat)
        return status


class CompositeDiagnosticTask(DiagnosticTask):
    """Several tasks with one status: all their values, the worst of their levels."""

    def __init__(self, name: str) -> None:
        super().__init__(name)
        self.tasks: list[DiagnosticTask] = []

    def run(self, stat: DiagnosticStatusWrapper) -> DiagnosticStatusWrapper:
        """Run all tasks."""
        level, message = stat.level, stat.message
        together = DiagnosticStatusWrapper()
        for task in self.tasks:
            stat.summary(level, message)
            stat = task.run(stat)
            together.mergeSummary(stat)
        stat.summary(together)
        return stat

    def addTask(self, t: DiagnosticTask) -> None:
        """Add a task."""
        self.tasks.append(t)


class DiagnosticTaskVector:
    """Tasks with one status each; `add` takes a task, or a name and a function."""

    def __init__(self) -> None:
        self.tasks: list[DiagnosticTask] = []
        self.lock = threading.Lock()

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        """Called after each task that is added."""

    def add(self, *args: Any) -> None:
        """Add a task, or a name and a function."""
        task = args[0] if len(args) == 1 else FunctionDiagnosticTask(*args)
        with self.lock:
            self.tasks.append(task)
        self.addedTaskCallback(task)

    def removeByName(self, name: str) -> bool:
        """Remove the tasks with that name. Return whether there were any."""
        with self.lock:
            kept = [task for task in self.tasks if task.getName() != name]
            found, self.tasks = len(kept) < len(self.tasks), kept
        return found


class Updater(DiagnosticTaskVector):
    """Runs its tasks every `period` seconds and publishes their statuses on /diagnostics."""

    def __init__(self, node: Node, period: float = 1.0) -> None:
        super().__init__()
        self.node = node
        self.verbose = False
        self.hwid = ""
        self.warn_nohwid_done = False
        name = "diagnostic_updater.period"
        declared = node.get_parameter(name) if node.has_parameter(name) else node.declare_parameter(name, period)
        self.__period = float(declared.value)
        self.publisher = node.create_publisher(DiagnosticArray, "/diagnostics", 1)
        self.timer = node.create_timer(self.__period, self.update)

    @property
    def period(self) -> float:
        """Seconds between two reports."""
        return self.__period

    @period.setter
    def period(self, value: float) -> None:
        self.__period = float(value)
        self.node.destroy_timer(self.timer)
        self.timer = self.node.create_timer(self.__period, self.update)

    def update(self) -> None:
        """Publish all statuses, and warn once if no hardware ID is set."""
        if not self.hwid and not self.warn_nohwid_done:
            self.node.get_logger().warning(
                "diagnostic_updater: No HW_ID was set. This is probably a bug. Please report it. For devices that do not "
                "have a HW_ID, set this value to 'none'. This warning only occurs once all diagnostics are OK so it is "
                "okay to wait until the device is open before calling setHardwareID."
            )
            self.warn_nohwid_done = True
        self.force_update()

    def force_update(self) -> None:
        """Publish all statuses now."""
        with self.lock:
            tasks = list(self.tasks)
        self.publish([self._asked(task) for task in tasks])

    def _asked(self, task: DiagnosticTask) -> DiagnosticStatusWrapper:
        status = DiagnosticStatusWrapper()
        status.name, status.hardware_id = task.name, self.hwid
        status.summary(DiagnosticStatus.ERROR, "No message was set")
        status = task.run(status)
        if self.verbose and status.level:
            self.node.get_logger().warning(f"Non-zero diagnostic status. Name: '{status.name}', message: '{status.message}'")
        return status

    def broadcast(self, lvl: Any, msg: str) -> None:
        """Publish the same level and message for all tasks."""
        told = []
        for task in self.tasks:
            status = DiagnosticStatusWrapper(name=task.name)
            status.summary(lvl, msg)
            told.append(status)
        self.publish(told)

    def setHardwareID(self, hwid: str) -> None:
        """Set the hardware ID of the device; "none" if it has none."""
        self.hwid = hwid

    def setHardwareIDf(self, format: str, *args: Any) -> None:
        """Set the hardware ID from a format string with % and its arguments."""
        self.hwid = format % args

    def publish(self, msg: Any) -> None:
        """Publish one status or several, with the node's name before theirs."""
        array = DiagnosticArray()
        array.header.stamp = self.node.get_clock().now().to_msg()
        for status in msg if isinstance(msg, list) else [msg]:
            told = DiagnosticStatus(level=status.level, message=status.message, values=status.values)
            told.name, told.hardware_id = f"{self.node.get_name()}: {status.name}", status.hardware_id
            array.status.append(told)
        self.publisher.publish(array)

    def addedTaskCallback(self, task: DiagnosticTask) -> None:
        """Publish that a new task is starting up."""
        status = DiagnosticStatusWrapper(name=task.name)
        status.summary(DiagnosticStatus.OK, "Node starting up")
        self.publish(status)
