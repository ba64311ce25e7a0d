"""`ros2 run ros2_controllers_test_nodes publisher_joint_trajectory_controller`: points of a trajectory in turn."""

from __future__ import annotations

import math
import sys

from builtin_interfaces.msg import Duration
from rcl_interfaces.msg import ParameterDescriptor
from rclpy.node import Node
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from coursekit.nodes.running import run

PARTS = ("positions", "velocities", "accelerations", "effort")
SECONDS_TO_GOAL = 4
STRUCTURE = (
    "Use the following structure: \n<goal_name>:\n  positions: [joint1, joint2, joint3, ...]\n  "
    "velocities: [v_joint1, v_joint2, ...]\n  accelerations: [a_joint1, a_joint2, ...]\n  "
    "effort: [eff_joint1, eff_joint2, ...]"
)


class PublisherJointTrajectory(Node):
    """Publishes its goals in turn; with `check_starting_point` only where the joints begin within their limits."""

    def __init__(self) -> None:
        super().__init__("publisher_position_trajectory_controller")
        controller = self.declare_parameter("controller_name", "position_trajectory_controller").value
        period = self.declare_parameter("wait_sec_between_publish", 6).value
        names = self.declare_parameter("goal_names", ["pos1", "pos2"]).value
        self._joints: list[str] = self.declare_parameter("joints", [""]).value
        self._checked = bool(self.declare_parameter("check_starting_point", False).value)
        if not self._joints:
            raise Exception('"joints" parameter is not set!')
        self._heard, self._may_start = False, not self._checked
        self._limits = self._watch_start() if self._checked else {}
        self._goals = [point for name in names if (point := self._goal(name)) is not None]
        self._next = 0
        if not self._goals:
            self.get_logger().error("No valid goal found. Exiting...")
            sys.exit(1)
        topic = f"/{controller}/joint_trajectory"
        self.get_logger().info(f'Publishing {len(names)} goals on topic "{topic}" every {period} s')
        self._out = self.create_publisher(JointTrajectory, topic, 1)
        self.create_timer(period, self._send)

    def _watch_start(self) -> dict[str, list[float]]:
        usual = [-2 * math.pi, 2 * math.pi]
        limits = {name: self.declare_parameter(f"starting_point_limits.{name}", usual).value for name in self._joints}
        if any(len(pair) != 2 for pair in limits.values()):
            raise Exception('"starting_point" parameter is not set correctly!')
        self.create_subscription(JointState, "joint_states", self._hear, 10)
        return limits

    def _goal(self, name: str) -> JointTrajectoryPoint | None:
        self.declare_parameter(name, descriptor=ParameterDescriptor(dynamic_typing=True))
        given = {part: self.declare_parameter(f"{name}.{part}", [0.0]).value for part in PARTS}
        fitting = {part: list(map(float, row)) for part, row in given.items() if len(row) == len(self._joints)}
        if not fitting:
            self.get_logger().warning(f'Goal "{name}" definition is wrong. This goal will not be used. {STRUCTURE}')
            return None
        point = JointTrajectoryPoint(time_from_start=Duration(sec=SECONDS_TO_GOAL), **fitting)
        self.get_logger().info(f'Goal "{name}" has definition {point}')
        return point

    def _send(self) -> None:
        if self._may_start:
            goal = self._goals[self._next]
            self.get_logger().info(f"Sending goal {goal}.")
            self._out.publish(JointTrajectory(joint_names=self._joints, points=[goal]))
            self._next = (self._next + 1) % len(self._goals)
        elif self._heard:
            self.get_logger().warning("Start configuration is not within configured limits!")
        else:
            self.get_logger().warning('Start configuration could not be checked! Check "joint_state" topic!')

    def _hear(self, msg: JointState) -> None:
        if self._heard:
            return
        self._heard = self._may_start = True
        for name, position in zip(msg.name, msg.position, strict=False):
            low, high = self._limits.get(name, (-math.inf, math.inf))
            if not low <= position <= high:
                self.get_logger().warning(f"Starting point limits exceeded for joint {name} !")
                self._may_start = False


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(PublisherJointTrajectory, args)
