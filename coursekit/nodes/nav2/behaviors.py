"""The behaviours of a behaviour server; each is a coroutine that handles one goal of an action."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Twist
from nav2_msgs.action import AssistedTeleop, BackUp, DriveOnHeading, Spin, Wait
from rclpy.duration import Duration
from std_msgs.msg import Empty

from coursekit.geometry.plane import wrap

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle

    from coursekit.nodes.nav2.behavior_server import BehaviorServer

Speeds = tuple[float, float]


async def spin(server: BehaviorServer, name: str, handle: ServerGoalHandle) -> Any:
    """Rotate in place by `target_yaw` [rad]."""
    target, turned, last = handle.request.target_yaw, 0.0, server.heading()
    server.get_logger().info(f"Turning {target:.2f} for spin behavior.")

    def step(_seconds: float) -> Speeds | None:
        nonlocal turned, last
        now = server.heading()
        turned, last = turned + wrap(now - last), now
        left = abs(target) - abs(turned)
        handle.publish_feedback(Spin.Feedback(angular_distance_traveled=float(turned)))
        if left < 1e-2:
            return None
        fastest, slowest = server.given["max_rotational_vel"], server.given["min_rotational_vel"]
        rate = min(fastest, max(slowest, math.sqrt(2 * server.given["rotational_acc_lim"] * left)))
        return 0.0, math.copysign(min(rate, max(left * 3.0, 0.1)), target)

    return await server.behave(handle, Spin, name, step)


async def back_up(server: BehaviorServer, name: str, handle: ServerGoalHandle) -> Any:
    """Drive straight backwards."""
    return await _go(server, handle, BackUp, name, -abs(handle.request.target.x), -abs(handle.request.speed))


async def straight(server: BehaviorServer, name: str, handle: ServerGoalHandle) -> Any:
    """Drive straight ahead, or backwards with negative distance and speed."""
    request = handle.request
    if request.target.x * request.speed < 0:
        server.get_logger().error("Speed and command sign did not match")
        handle.abort()
        return DriveOnHeading.Result()
    return await _go(server, handle, DriveOnHeading, name, request.target.x, request.speed)


async def _go(
    server: BehaviorServer, handle: ServerGoalHandle, kind: type[Any], name: str, distance: float, speed: float
) -> Any:
    if handle.request.target.y or handle.request.target.z:
        server.get_logger().info(f"Backing up in Y and Z not supported, will only move in X ({name}).")
        handle.abort()
        return kind.Result()
    begin = server.pose()

    def step(_seconds: float) -> Speeds | None:
        here = server.pose()
        gone = 0.0 if begin is None or here is None else begin.distance(here)
        handle.publish_feedback(kind.Feedback(distance_traveled=float(gone)))
        return None if gone >= abs(distance) else (speed, 0.0)

    return await server.behave(handle, kind, name, step)


async def wait(server: BehaviorServer, name: str, handle: ServerGoalHandle) -> Any:
    """Wait without moving."""
    seconds = handle.request.time.sec + handle.request.time.nanosec * 1e-9

    def step(gone: float) -> Speeds | None:
        left = max(seconds - gone, 0.0)
        handle.publish_feedback(Wait.Feedback(time_left=Duration(seconds=left).to_msg()))
        return None if gone >= seconds else (0.0, 0.0)

    return await server.behave(handle, Wait, name, step)


async def assisted_teleop(server: BehaviorServer, name: str, handle: ServerGoalHandle) -> Any:
    """Follow `cmd_vel_teleop`, slower near obstacles, until `preempt_teleop` or the time is up."""
    wish, ended = Twist(), False

    def hear(msg: Twist) -> None:
        nonlocal wish
        wish = msg

    def end(_msg: Empty) -> None:
        nonlocal ended
        ended = True

    heard = [
        server.create_subscription(Twist, server.given["cmd_vel_teleop"], hear, 10),
        server.create_subscription(Empty, "preempt_teleop", end, 10),
    ]

    def step(gone: float) -> Speeds | None:
        handle.publish_feedback(AssistedTeleop.Feedback(current_teleop_duration=Duration(seconds=gone).to_msg()))
        return None if ended else server.slowed((wish.linear.x, wish.angular.z))

    try:
        return await server.behave(handle, AssistedTeleop, name, step, blind=True)
    finally:
        for subscription in heard:
            server.destroy_subscription(subscription)


KINDS = {
    "nav2_behaviors/Spin": (Spin, spin),
    "nav2_behaviors/BackUp": (BackUp, back_up),
    "nav2_behaviors/DriveOnHeading": (DriveOnHeading, straight),
    "nav2_behaviors/AssistedTeleop": (AssistedTeleop, assisted_teleop),
    "nav2_behaviors/Wait": (Wait, wait),
}
"""Plugins: their actions and coroutines."""
USUAL = {
    "spin": "nav2_behaviors/Spin",
    "backup": "nav2_behaviors/BackUp",
    "drive_on_heading": "nav2_behaviors/DriveOnHeading",
    "assisted_teleop": "nav2_behaviors/AssistedTeleop",
    "wait": "nav2_behaviors/Wait",
}
