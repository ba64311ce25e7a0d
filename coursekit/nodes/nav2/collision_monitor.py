"""`ros2 run nav2_collision_monitor collision_monitor`: slows or stops the robot near obstacles."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from geometry_msgs.msg import Twist
from nav2_msgs.msg import CollisionMonitorState
from rclpy.lifecycle import LifecycleState, TransitionCallbackReturn
from tf2_ros import TransformException

from coursekit.nav.zones import STILL, Speeds, pace
from coursekit.nodes.nav2.collision_sources import SensorSource
from coursekit.nodes.nav2.collision_zones import RobotZone
from coursekit.nodes.nav2.parameters import declare
from coursekit.nodes.nav2.running import Server, run
from coursekit.nodes.nav2.transform_lookup import TransformLookup
from coursekit.nodes.scanning.planar import of_transform
from coursekit.nodes.scanning.scan_filter import lookup

if TYPE_CHECKING:
    from std_msgs.msg import Header

    from coursekit.geometry.plane import Array

_SERVER: dict[str, Any] = {
    "cmd_vel_in_topic": "cmd_vel_raw",
    "cmd_vel_out_topic": "cmd_vel",
    "state_topic": "",
    "base_frame_id": "base_footprint",
    "odom_frame_id": "odom",
    "transform_tolerance": 0.1,
    "source_timeout": 2.0,
    "base_shift_correction": True,
    "stop_pub_timeout": 1.0,
    "polygons": [],
    "observation_sources": [],
}
_NUMBERS = {
    "stop": CollisionMonitorState.STOP, "slowdown": CollisionMonitorState.SLOWDOWN,
    "approach": CollisionMonitorState.APPROACH, "limit": CollisionMonitorState.LIMIT,
}  # fmt: skip


class CollisionMonitor(Server):
    """Filters velocity commands: of the zones with obstacles in them, the one with the lowest speed applies."""

    def __init__(self) -> None:
        super().__init__("collision_monitor")
        declare(self, _SERVER)

    # -- states

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Subscribe to the sensors; FAILURE for invalid parameters."""
        self.get_logger().info("Configuring")
        self.zones: list[RobotZone] = []
        self.sources: list[SensorSource] = []
        try:
            self._read()
        except ValueError as fault:
            self.get_logger().error(str(fault))
            self._close()
            return TransitionCallbackReturn.FAILURE
        given = self._given
        self._active, self._last, self._stopped_ns = False, ("", ""), -1
        self._out = self.create_lifecycle_publisher(Twist, given["cmd_vel_out_topic"], 1)
        self._state_out = (
            self.create_lifecycle_publisher(CollisionMonitorState, given["state_topic"], 1) if given["state_topic"] else None
        )
        self._ear = self.create_subscription(Twist, given["cmd_vel_in_topic"], self._hear, 1)
        return super().on_configure(state)

    def _read(self) -> None:
        self._given = given = declare(self, _SERVER)
        for name, example in (("polygons", "PolygonStop"), ("observation_sources", "scan")):
            if not given[name]:
                raise ValueError(
                    f"{self.get_name()}: {name} is empty: nothing would be watched. Name some, as ['{example}']"
                )
        self._where = TransformLookup(self, given["base_frame_id"])
        for name in given["polygons"]:
            self.zones.append(RobotZone(self, name))
        for name in given["observation_sources"]:
            self.sources.append(SensorSource(self, self._where, name, given))

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start passing velocities on."""
        done = super().on_activate(state)
        self._active = True
        self._show()
        return done

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop passing velocities on."""
        self._active = False
        return super().on_deactivate(state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Drop the subscriptions."""
        self._close()
        self.destroy_subscription(self._ear)
        for publisher in (self._out, self._state_out):
            if publisher is not None:
                self.destroy_lifecycle_publisher(publisher)
        return super().on_cleanup(state)

    def _close(self) -> None:
        for zone in self.zones:
            zone.close()
        for source in self.sources:
            source.close()
        if hasattr(self, "_where"):
            self._where.close()

    # -- velocities

    def _hear(self, msg: Twist) -> None:
        wish = (msg.linear.x, msg.linear.y, msg.angular.z)
        if not all(map(math.isfinite, wish)):
            self.get_logger().error("Velocity message contains NaNs or Infs! Ignoring as invalid!")
        elif self._active:
            self._say(self._allowed(wish))
            self._show()

    def around_robot(self, corners: Array, header: Header) -> Array | None:
        """Transform corners (n, 2) from a message's frame to the robot's; None if tf has no transform for that time."""
        try:
            seat = lookup(self._where.buffer, header.frame_id, self._given["base_frame_id"], header.stamp)
        except TransformException as fault:
            self.get_logger().error(f"The footprint cannot be used: {fault}", throttle_duration_sec=1.0)
            return None
        return of_transform(seat).inverse().transform(corners)

    def _allowed(self, wish: Speeds) -> Speeds:
        points = np.concatenate([source.points() for source in self.sources])
        best, by = wish, None
        for zone in self.zones:
            asked = zone.wish(points, wish)
            if asked is not None and (zone.action == "stop" or pace(asked) < pace(best)):
                best, by = asked, zone
            if zone is by and zone.action == "stop":
                break
        self._report(by, best, wish)
        return best

    def _report(self, by: RobotZone | None, best: Speeds, wish: Speeds) -> None:
        now = (by.action, by.name) if by is not None else ("", "")
        if now == self._last:
            return
        self._last = now
        self.get_logger().info(by.words(best, wish) if by is not None else "Robot to continue normal operation")
        if self._state_out is not None:
            self._state_out.publish(CollisionMonitorState(action_type=_NUMBERS.get(now[0], 0), polygon_name=now[1]))

    def _say(self, speeds: Speeds) -> None:
        """Publish; stop publishing zero velocities after `stop_pub_timeout` seconds, so that others may drive the robot."""
        now = self.get_clock().now().nanoseconds
        if speeds == STILL:
            if self._stopped_ns < 0:
                self._stopped_ns = now
            elif (now - self._stopped_ns) * 1e-9 > self._given["stop_pub_timeout"]:
                return
        else:
            self._stopped_ns = -1
        msg = Twist()
        msg.linear.x, msg.linear.y, msg.angular.z = speeds
        self._out.publish(msg)

    def _show(self) -> None:
        for zone in self.zones:
            zone.show()


def main(args: list[str] | None = None) -> int:
    """Run the node until Ctrl-C."""
    return run(CollisionMonitor, args)
