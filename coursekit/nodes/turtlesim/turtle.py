"""One turtle's topics, services and action."""

from __future__ import annotations

import struct
from typing import Any

from geometry_msgs.msg import Twist
from rclpy.action import ActionServer, CancelResponse
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.task import Future
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import SetPen, TeleportAbsolute, TeleportRelative

from coursekit.sim.turtle import Rotation, Teleport, Turtle

_QOS = QoSProfile(depth=7)
_FLOATS = struct.Struct("<5f")


class TurtleInterface:
    """The interface of a turtle to ROS: its subscription, publishers, services and action."""

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self.node = node
        self.turtle = turtle
        self._goal: tuple[Any, Rotation, Future] | None = None
        name = turtle.name
        self._velocity = node.create_subscription(Twist, f"{name}/cmd_vel", self._command, _QOS)
        self._pose = node.create_publisher(Pose, f"{name}/pose", _QOS)
        self._color = node.create_publisher(Color, f"{name}/color_sensor", _QOS)
        self._services = [
            node.create_service(SetPen, f"{name}/set_pen", self._set_pen),
            node.create_service(TeleportRelative, f"{name}/teleport_relative", self._teleport_relative),
            node.create_service(TeleportAbsolute, f"{name}/teleport_absolute", self._teleport_absolute),
        ]
        self._action = ActionServer(
            node,
            RotateAbsolute,
            f"{name}/rotate_absolute",
            self._rotate,
            cancel_callback=lambda _goal: CancelResponse.ACCEPT,
        )

    def close(self) -> None:
        """Destroy the topics, the services and the action."""
        self._action.destroy()
        self.node.destroy_subscription(self._velocity)
        self.node.destroy_publisher(self._pose)
        self.node.destroy_publisher(self._color)
        for service in self._services:
            self.node.destroy_service(service)

    # -- requests

    def _command(self, twist: Twist) -> None:
        sideways = twist.linear.y if self.node.get_parameter("holonomic").value else 0.0
        self._end_goal("abort", "Velocity command received during rotation goal. Aborting goal")
        self.turtle.command(twist.linear.x, sideways, twist.angular.z, self.seconds())

    def seconds(self) -> float:
        """The node's time [s]."""
        return self.node.get_clock().now().nanoseconds * 1e-9

    def _set_pen(self, request: SetPen.Request, response: SetPen.Response) -> SetPen.Response:
        self.turtle.pen.change(request.r, request.g, request.b, request.width, bool(request.off))
        return response

    def _teleport_relative(
        self, request: TeleportRelative.Request, response: TeleportRelative.Response
    ) -> TeleportRelative.Response:
        self.turtle.teleports.append(Teleport(linear=request.linear, theta=request.angular, relative=True))
        return response

    def _teleport_absolute(
        self, request: TeleportAbsolute.Request, response: TeleportAbsolute.Response
    ) -> TeleportAbsolute.Response:
        self.turtle.teleports.append(Teleport(x=request.x, y=request.y, theta=request.theta))
        return response

    async def _rotate(self, goal_handle: Any) -> RotateAbsolute.Result:
        self._end_goal("abort", "Rotation goal received before a previous goal finished. Aborting previous goal")
        rotation = self.turtle.rotate_to(goal_handle.request.theta)
        ended = Future()
        self._goal = (goal_handle, rotation, ended)
        await ended
        return RotateAbsolute.Result(delta=rotation.delta)

    def _end_goal(self, how: str, warning: str = "") -> None:
        """End the active goal, if there is one."""
        if self._goal is None:
            return
        handle, _rotation, ended = self._goal
        self._goal = None
        self.turtle.rotation = None
        if warning:
            self.node.get_logger().warning(warning)
        getattr(handle, how)()
        ended.set_result(None)

    # -- publishing, every frame

    def before_step(self) -> None:
        """Stop a cancelled rotation."""
        if self._goal is not None and self._goal[0].is_cancel_requested:
            self.node.get_logger().info("Rotation goal canceled")
            self._end_goal("canceled")
            self.turtle.stop()

    def after_step(self) -> None:
        """Publish the rotation's feedback, the turtle's pose and the colour that it senses."""
        if self._goal is not None:
            handle, rotation, _ = self._goal
            handle.publish_feedback(RotateAbsolute.Feedback(remaining=rotation.remaining))
            if rotation.reached:
                self.node.get_logger().info("Rotation goal completed successfully")
                self._end_goal("succeed")
        turtle = self.turtle
        numbers = (turtle.x, turtle.y, turtle.theta, turtle.speed, turtle.turning)
        x, y, theta, linear, angular = _FLOATS.unpack(_FLOATS.pack(*numbers))
        self._pose.publish(Pose(x=x, y=y, theta=theta, linear_velocity=linear, angular_velocity=angular))
        red, green, blue = turtle.colour
        self._color.publish(Color(r=red, g=green, b=blue))
