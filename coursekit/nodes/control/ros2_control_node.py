"""`ros2 run controller_manager ros2_control_node`: the controller manager with mock hardware and compiled drivers."""

from __future__ import annotations

import contextlib
import sys
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

from coursekit.nodes.running import terminate, to_the_end
from coursekit.urdf import UrdfError

from .description import read_hardware
from .manager import Manager
from .manager_services import ManagerServices
from .resource_manager import WrongInterfaces, load

_NOT_GENUINE = "The published robot description file (urdf) seems not to be genuine. The following error was caught:"


def own_arguments(argv: list[str]) -> list[str]:
    """Return the ROS arguments for the controllers' nodes: all of the program's except its node name.

    >>> own_arguments(["x", "--ros-args", "-r", "__node:=cm", "--params-file", "a.yaml", "--"])
    ['--params-file', 'a.yaml']
    """
    arguments: list[str] = []
    within = False
    for word in argv:
        if word in ("--ros-args", "--"):
            within = word == "--ros-args"
        elif within and word.startswith(("__node:=", "__name:=")):
            arguments.pop()
        elif within:
            arguments.append(word)
    return arguments


class ControlNode:
    """The node and its manager, which wait for a robot description."""

    def __init__(self) -> None:
        self.node = Node(
            "controller_manager", allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
        )
        self.executor = rclpy.get_global_executor()
        self.executor.add_node(self.node)
        self.manager = Manager(self.node, self.executor, own_arguments(sys.argv))
        self.services = ManagerServices(self.manager)
        log = self.node.get_logger()
        if not self.node.has_parameter("robot_description"):
            self.node.declare_parameter("robot_description", "")
        text = str(self.node.get_parameter("robot_description").value or "")
        if text:
            log.warning(
                "[Deprecated] Passing the robot description parameter directly to the control_manager node is deprecated. "
                "Use '~/robot_description' topic from 'robot_state_publisher' instead."
            )
            self.describe(text)
        else:
            log.info("Subscribing to '~/robot_description' topic for robot description file.")
            latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
            for topic in ("~/robot_description", "robot_description"):
                self.node.create_subscription(String, topic, self._receive, latched)
        log.info(f"update rate is {self.manager.rate:g} Hz")
        self.manager.now_ns = self._last_ns = self.node.get_clock().now().nanoseconds
        self.node.create_timer(1.0 / self.manager.rate, self._step)

    def describe(self, text: str) -> None:
        """Add the hardware of a description; only the first one counts. Raises WrongInterfaces."""
        if self.manager.hardware:
            return
        log = self.node.get_logger()
        try:
            _, infos = read_hardware(text)
        except UrdfError as error:
            log.error(f"{_NOT_GENUINE} {error}")
            return
        if not infos:
            log.error("The robot description has no <ros2_control>: there is nothing to control.")
        for info in infos:
            if (hardware := load(info, text, self.manager.hardware_log)) is not None:
                self.manager.add(hardware)

    def _receive(self, msg: String) -> None:
        try:
            self.describe(msg.data)
        except WrongInterfaces as fault:
            self.node.get_logger().error(f"{_NOT_GENUINE} {fault}")

    def close(self) -> None:
        """End the controllers and the hardware.

        As on Humble, hardware is destroyed as it is: a driver that has to stop its motors does that in its destructor.
        """
        for loaded in self.manager.loaded.values():
            loaded.controller.leave(self.executor)
        for hardware in self.manager.hardware:
            hardware.close()

    def _step(self) -> None:
        now = self.node.get_clock().now().nanoseconds
        dt, self._last_ns = (now - self._last_ns) * 1e-9, now
        self.manager.update(now, max(dt, 0.0))


def main(args: list[str] | None = None) -> Any:
    """Run the controller manager until Ctrl-C."""
    rclpy.init(args=args)
    try:
        control = ControlNode()
    except WrongInterfaces as fault:
        return terminate(str(fault))
    with to_the_end():
        with contextlib.suppress(KeyboardInterrupt, ExternalShutdownException):
            control.executor.spin()
        control.close()
    return 0
