"""`ros2 run nav2_behaviors behavior_server`: turns on the spot, drives straight, waits; never into something."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from geometry_msgs.msg import PolygonStamped, Twist
from nav2_msgs.action import BackUp, DriveOnHeading, Spin, Wait
from nav2_msgs.msg import Costmap as CostmapMessage
from rclpy.duration import Duration
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.nav.controller import Controller, Limits
from coursekit.nav.costmap import Costmap
from coursekit.nav.footprint import Footprint
from coursekit.nodes.nav2.map_message import MAP_QOS
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Beat, Server, run
from coursekit.nodes.nav2.whereabouts import Whereabouts
from coursekit.slam.pose import Pose2, wrap

_SERVER: dict[str, Any] = {
    "costmap_topic": "local_costmap/costmap_raw",
    "footprint_topic": "local_costmap/published_footprint",
    "cycle_frequency": 10.0,
    "behavior_plugins": ["spin", "backup", "drive_on_heading", "wait"],
    "global_frame": "odom",
    "robot_base_frame": "base_link",
    "transform_tolerance": 0.1,
    "simulate_ahead_time": 2.0,
    "max_rotational_vel": 1.0,
    "min_rotational_vel": 0.4,
    "rotational_acc_lim": 3.2,
}
Step = Callable[[float], tuple[float, float] | None]
"""Seconds since it began → forward and turning speed, or None when it is done."""


class BehaviorServer(Server):
    """The actions spin, backup, drive_on_heading and wait."""

    def __init__(self) -> None:
        super().__init__("behavior_server")
        declare(self, _SERVER)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Offer the behaviours of `behavior_plugins`."""
        self.get_logger().info("Configuring")
        try:
            given = self.given = declare(self, _SERVER)
        except ValueError as fault:
            self.get_logger().error(str(fault))
            return TransitionCallbackReturn.FAILURE
        self._costs: Costmap | None = None
        self._robot: Footprint | None = None
        self._raw: PolygonStamped | None = None
        self._where = Whereabouts(self, given["robot_base_frame"])
        self._cmd_out = self.create_lifecycle_publisher(Twist, "cmd_vel", 1)
        self._heard = [
            self.create_subscription(CostmapMessage, given["costmap_topic"], self._take_costmap, MAP_QOS),
            self.create_subscription(PolygonStamped, given["footprint_topic"], self._take_outline, 10),
        ]
        kinds = {"spin": (Spin, self._spin), "backup": (BackUp, self._back_up), "wait": (Wait, self._wait)}
        kinds["drive_on_heading"] = (DriveOnHeading, self._straight)
        for name in given["behavior_plugins"]:
            if name in kinds:
                self.serve(kinds[name][0], name, kinds[name][1])
            else:
                self.get_logger().warning(f"There is no behavior '{name}' here; known are {', '.join(kinds)}")
        return super().on_configure(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Forget all."""
        for heard in self._heard:
            self.destroy_subscription(heard)
        self._where.close()
        self.destroy_lifecycle_publisher(self._cmd_out)
        return super().on_cleanup(state)

    # -- what is heard

    def _take_costmap(self, msg: CostmapMessage) -> None:
        meta = msg.metadata
        cells = np.array(msg.data, dtype=np.uint8).reshape(meta.size_y, meta.size_x)
        self._costs = Costmap(cells, float(f"{meta.resolution:.6g}"), meta.origin.position.x, meta.origin.position.y)

    def _take_outline(self, msg: PolygonStamped) -> None:
        self._raw = msg
        try:
            here = self._where.robot(msg.header.frame_id)
        except TransformException:
            return
        points = np.array([(one.x, one.y) for one in msg.polygon.points], dtype=float)
        if len(points) >= 3 and self._robot is None:
            corners = here.inverse().transform(points)
            self._robot = Footprint(corners)

    # -- behaviours

    async def _spin(self, handle: Any) -> Any:
        target, turned, last = handle.request.target_yaw, 0.0, self._heading()
        self.get_logger().info(f"Turning {target:.2f} for spin behavior.")

        def step(_seconds: float) -> tuple[float, float] | None:
            nonlocal turned, last
            now = self._heading()
            turned, last = turned + wrap(now - last), now
            left = abs(target) - abs(turned)
            handle.publish_feedback(Spin.Feedback(angular_distance_traveled=float(turned)))
            if left < 1e-2:
                return None
            fastest, slowest = self.given["max_rotational_vel"], self.given["min_rotational_vel"]
            rate = min(fastest, max(slowest, math.sqrt(2 * self.given["rotational_acc_lim"] * left)))
            return 0.0, math.copysign(min(rate, max(left * 3.0, 0.1)), target)

        return await self._behave(handle, Spin, "spin", step)

    async def _back_up(self, handle: Any) -> Any:
        return await self._go(handle, BackUp, "backup", -abs(handle.request.target.x), -abs(handle.request.speed))

    async def _straight(self, handle: Any) -> Any:
        request = handle.request
        if request.target.x * request.speed < 0:
            self.get_logger().error("Speed and command sign did not match")
            handle.abort()
            return DriveOnHeading.Result()
        return await self._go(handle, DriveOnHeading, "drive_on_heading", request.target.x, request.speed)

    async def _go(self, handle: Any, kind: Any, name: str, distance: float, speed: float) -> Any:
        if handle.request.target.y or handle.request.target.z:
            self.get_logger().info(f"Backing up in Y and Z not supported, will only move in X ({name}).")
            handle.abort()
            return kind.Result()
        begin = self._pose()

        def step(_seconds: float) -> tuple[float, float] | None:
            here = self._pose()
            gone = 0.0 if begin is None or here is None else begin.distance(here)
            handle.publish_feedback(kind.Feedback(distance_traveled=float(gone)))
            return None if gone >= abs(distance) else (speed, 0.0)

        return await self._behave(handle, kind, name, step)

    async def _wait(self, handle: Any) -> Any:
        seconds = handle.request.time.sec + handle.request.time.nanosec * 1e-9

        def step(gone: float) -> tuple[float, float] | None:
            left = max(seconds - gone, 0.0)
            handle.publish_feedback(Wait.Feedback(time_left=Duration(seconds=left).to_msg()))
            return None if gone >= seconds else (0.0, 0.0)

        return await self._behave(handle, Wait, "wait", step)

    async def _behave(self, handle: Any, kind: Any, name: str, step: Step) -> Any:
        """Do a behaviour step by step until it is done, or cannot go on, or someone says stop."""
        self.get_logger().info(f"Running {name}")
        action = next(one for one in self.actions if one.current is handle)
        result, begin = kind.Result(), self.get_clock().now()
        allowed = getattr(handle.request, "time_allowance", None)
        most = (allowed.sec + allowed.nanosec * 1e-9) if allowed else 0.0
        beat = Beat(self, 1.0 / self.given["cycle_frequency"])
        try:
            while True:
                gone = (self.get_clock().now() - begin).nanoseconds * 1e-9
                end = self._step(action, handle, name, step, gone, most)
                if end is not None:
                    break
                await beat.next()
        finally:
            beat.stop()
        self._drive((0.0, 0.0))
        result.total_elapsed_time = (self.get_clock().now() - begin).to_msg()
        end()
        return result

    def _step(self, action: Any, handle: Any, name: str, step: Step, gone: float, most: float) -> Any:
        """One command; how the goal ends, once it does."""
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
        if speeds != (0.0, 0.0) and self._pose() is None:
            log.error(f"Current robot pose is not available: tf does not know {self.given['robot_base_frame']}.")
            return handle.abort
        if speeds != (0.0, 0.0) and self._collides(speeds):
            log.warning(f"Collision Ahead - Exiting {name}")
            return handle.abort
        self._drive(speeds)
        return None

    # -- the robot

    def _pose(self) -> Pose2 | None:
        try:
            return self._where.robot(self.given["global_frame"])
        except TransformException:
            return None

    def _heading(self) -> float:
        here = self._pose()
        return here.theta if here is not None else 0.0

    def _collides(self, speeds: tuple[float, float]) -> bool:
        """Whether the robot would touch something soon that it does not touch already."""
        here, costs, robot = self._pose(), self._costs, self._robot
        if here is None or costs is None or robot is None:
            return False
        body = Controller(Limits(), robot, scaling=(0.0, 1.0))
        at, step = here, 0.1
        if body.blocked(costs, here):
            return False
        for _ in range(max(round(min(self.given["simulate_ahead_time"], 1.0) / step), 1)):
            at = at @ Pose2(speeds[0] * step, 0.0, speeds[1] * step)
            if body.blocked(costs, at):
                return True
        return False

    def _drive(self, speeds: tuple[float, float]) -> None:
        msg = Twist()
        msg.linear.x, msg.angular.z = speeds
        self._cmd_out.publish(msg)


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(BehaviorServer, args)
