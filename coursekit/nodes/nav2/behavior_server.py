"""`ros2 run nav2_behaviors behavior_server`: spins, drives straight and waits, without collisions."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import PolygonStamped, Twist
from nav2_msgs.msg import Costmap as CostmapMessage
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.geometry.plane import Pose2D
from coursekit.nav.controller import Controller, Limits
from coursekit.nav.costmap import Costmap
from coursekit.nav.footprint import Footprint
from coursekit.nodes.compiled.classes import CppFault
from coursekit.nodes.nav2.behaviors import KINDS, USUAL
from coursekit.nodes.nav2.cpp_behavior import CppBehavior
from coursekit.nodes.nav2.cpp_plugins import CppPlugins, where_is
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import Obedience, declare
from coursekit.nodes.nav2.running import AsyncRate, Server, SingleGoal, run
from coursekit.nodes.nav2.transform_lookup import TransformLookup

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle

_SERVER: dict[str, Any] = {
    "costmap_topic": "local_costmap/costmap_raw",
    "footprint_topic": "local_costmap/published_footprint",
    "cycle_frequency": 10.0,
    "behavior_plugins": list(USUAL),
    "global_frame": "odom",
    "robot_base_frame": "base_link",
    "transform_tolerance": 0.1,
    "simulate_ahead_time": 2.0,
    "max_rotational_vel": 1.0,
    "min_rotational_vel": 0.4,
    "rotational_acc_lim": 3.2,
    "projection_time": 1.0,
    "simulation_time_step": 0.1,
    "cmd_vel_teleop": "cmd_vel_teleop",
}
Step = Callable[[float], tuple[float, float] | None]
"""Seconds since the start → linear and angular velocity, or None when done."""


class BehaviorServer(Server):
    """The actions of `behavior_plugins`: spin, backup, drive_on_heading, wait, assisted_teleop."""

    def __init__(self) -> None:
        super().__init__("behavior_server")
        declare(self, _SERVER)
        self._foreign = CppPlugins(self)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Create the behaviours in `behavior_plugins`."""
        self.get_logger().info("Configuring")
        try:
            self._read()
            given = self.given
            chosen = {name: self._kind(name) for name in given["behavior_plugins"]}
        except ValueError as fault:
            return self._foreign.refused(fault)
        self._obedience = Obedience(self, self._read)
        self._costs: Costmap | None = None
        self._robot: Footprint | None = None
        self.where = TransformLookup(self, given["robot_base_frame"])
        self._cmd_out = self.create_lifecycle_publisher(Twist, "cmd_vel", 1)
        self._heard = [
            self.create_subscription(CostmapMessage, given["costmap_topic"], self._take_costmap, MAP_QOS),
            self.create_subscription(PolygonStamped, given["footprint_topic"], self._take_outline, 10),
        ]
        try:
            for name, plugin in chosen.items():
                self._make(name, plugin)
        except CppFault:
            self._foreign.end()
            self.on_cleanup(state)
            raise
        return super().on_configure(state)

    def _make(self, name: str, plugin: str) -> None:
        if plugin not in KINDS:
            self._foreign.get(CppBehavior, name, plugin, KINDS)
            return
        self.get_logger().info(CppBehavior.created.format(name=name, kind=plugin))
        action, work = KINDS[plugin]
        self.serve(action, name, partial(work, self, name))

    def activate_parts(self) -> bool:
        """Activate the behaviours."""
        self._foreign.change("activate")
        return True

    def deactivate_parts(self) -> None:
        """Deactivate the behaviours."""
        self._foreign.change("deactivate")

    def _read(self) -> None:
        """Read the parameters. ValueError for invalid ones."""
        given = declare(self, _SERVER)
        if not (given["cycle_frequency"] > 0 and given["simulation_time_step"] > 0 and given["projection_time"] > 0):
            raise ValueError("cycle_frequency, simulation_time_step and projection_time should be greater than 0")
        self.given = given

    def _kind(self, name: str) -> str:
        """Return the plugin of a behaviour. NoPlugin for an unknown one."""
        plugin: str = declare(self, {"plugin": USUAL.get(name, "")}, name)["plugin"]
        if plugin not in KINDS:
            where_is(CppBehavior, name, plugin, KINDS)
        return plugin

    def clean_parts(self) -> None:
        """Destroy everything."""
        self._obedience.end()
        self._foreign.retire()
        for heard in self._heard:
            self.destroy_subscription(heard)
        self.where.close()
        self.destroy_lifecycle_publisher(self._cmd_out)

    # -- inputs

    def _take_costmap(self, msg: CostmapMessage) -> None:
        meta = msg.metadata
        cells = np.array(msg.data, dtype=np.uint8).reshape(meta.size_y, meta.size_x)
        self._costs = Costmap(cells, float(f"{meta.resolution:.6g}"), meta.origin.position.x, meta.origin.position.y)

    def _take_outline(self, msg: PolygonStamped) -> None:
        try:
            here = self.where.robot(msg.header.frame_id)
        except TransformException:
            return
        points = np.array([(point.x, point.y) for point in msg.polygon.points], dtype=float)
        if len(points) >= 3 and self._robot is None:
            corners = here.inverse().transform(points)
            self._robot = Footprint(corners)

    # -- behaviours

    async def behave(self, handle: ServerGoalHandle, kind: type[Any], name: str, step: Step, *, blind: bool = False) -> Any:
        """Run a behaviour step by step until it is done, fails, or is cancelled.

        It also ends if an obstacle is in the way, unless it is `blind`, that is, does its own checks.
        """
        self.get_logger().info(f"Running {name}")
        action = next(running for running in self.actions if running.current is handle)
        result, begin = kind.Result(), self.get_clock().now()
        allowed = getattr(handle.request, "time_allowance", None)
        most = (allowed.sec + allowed.nanosec * 1e-9) if allowed else 0.0
        rate = AsyncRate(self, 1.0 / self.given["cycle_frequency"])
        try:
            while True:
                gone = (self.get_clock().now() - begin).nanoseconds * 1e-9
                end = self._step(action, handle, name, step, gone, most, blind)
                if end is not None:
                    break
                await rate.sleep()
        finally:
            rate.destroy()
        self.drive((0.0, 0.0))
        result.total_elapsed_time = (self.get_clock().now() - begin).to_msg()
        end()
        return result

    def _step(
        self, action: SingleGoal, handle: ServerGoalHandle, name: str, step: Step, gone: float, most: float, blind: bool
    ) -> Any:
        """Run one step. Returns the goal's result once it ends."""
        log = self.get_logger()
        if action.replaced(handle):
            return handle.abort
        if handle.is_cancel_requested:
            log.info(f"Canceling {name}")
            return handle.canceled
        if most > 0 and gone > most:
            log.warning(f"Exceeded time allowance before reaching the {name} goal - Exiting {name}")
            return handle.abort
        speeds = step(gone)
        if speeds is None:
            log.info(f"{name} completed successfully")
            return handle.succeed
        if speeds != (0.0, 0.0) and self.pose() is None:
            log.error(f"Current robot pose is not available: tf does not know {self.given['robot_base_frame']}.")
            return handle.abort
        if speeds != (0.0, 0.0) and not blind and self.free_for(speeds, self.given["simulate_ahead_time"]) < 1.0:
            log.warning(f"Collision Ahead - Exiting {name}")
            return handle.abort
        self.drive(speeds)
        return None

    # -- the robot

    def pose(self) -> Pose2D | None:
        """Return the robot's pose in `global_frame`, or None if tf does not have it."""
        try:
            return self.where.robot(self.given["global_frame"])
        except TransformException:
            return None

    def heading(self) -> float:
        """Return the robot's heading [rad]."""
        here = self.pose()
        return here.theta if here is not None else 0.0

    def free_for(self, speeds: tuple[float, float], seconds: float) -> float:
        """Return how long the robot can go on until it hits something that it does not touch already, at most 1 s."""
        here, costs, robot = self.pose(), self._costs, self._robot
        most, step = min(seconds, 1.0), self.given["simulation_time_step"]
        if here is None or costs is None or robot is None:
            return 1.0
        body, at = Controller(Limits(), robot, scaling=(0.0, 1.0)), here
        if body.blocked(costs, here):
            return 1.0
        for k in range(1, max(round(most / step), 1) + 1):
            at = at @ Pose2D(speeds[0] * step, 0.0, speeds[1] * step)
            if body.blocked(costs, at):
                return (k - 1) * step
        return 1.0

    def slowed(self, speeds: tuple[float, float]) -> tuple[float, float]:
        """Return speeds reduced so that nothing is hit within `projection_time`."""
        most = self.given["projection_time"]
        share = min(self.free_for(speeds, most) / most, 1.0)
        if share < 1.0:
            self.get_logger().info(f"Collision approaching in {share * most:.2f} seconds", throttle_duration_sec=1.0)
        return speeds[0] * share, speeds[1] * share

    def drive(self, speeds: tuple[float, float]) -> None:
        """Publish the velocity command."""
        msg = Twist()
        msg.linear.x, msg.angular.z = speeds
        self._cmd_out.publish(msg)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(BehaviorServer, args)
