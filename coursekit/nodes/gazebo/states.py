"""gazebo_ros_state: services and topics to get and set the state of models and links."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from gazebo_msgs.msg import EntityState, LinkStates, ModelStates
from gazebo_msgs.srv import GetEntityState, SetEntityState, SetModelConfiguration
from geometry_msgs.msg import Pose, Twist

from coursekit.geometry.plane import Pose2D

from .entity_poses import WORLD, Speed, planar_pose
from .sensor_publishers import heading, stamp_of
from .world_plugins import StatePlugin

if TYPE_CHECKING:
    from rclpy.publisher import Publisher

    from coursekit.nodes.gazebo.server import Gazebo


class States:
    """The simulated plugin. If the world does not load it, the simulator's node provides it without link states."""

    def __init__(self, gazebo: Gazebo, plugin: StatePlugin | None) -> None:
        self._gazebo, self._around = gazebo, gazebo.around
        node = self._node = gazebo.node_of(plugin.names.full_node) if plugin else gazebo
        named = plugin.names.topic if plugin else str
        node.create_service(GetEntityState, named("get_entity_state"), self._get)
        node.create_service(SetEntityState, named("set_entity_state"), self._set)
        node.create_service(SetModelConfiguration, named("set_joint_positions"), self._joints)
        self._models = node.create_publisher(ModelStates, named("model_states"), 10)
        self._links = node.create_publisher(LinkStates, named("link_states"), 10) if plugin else None
        node.create_timer(1.0 / (plugin.rate if plugin else 10.0), self._tell)

    def _get(self, request: GetEntityState.Request, answer: GetEntityState.Response) -> GetEntityState.Response:
        answer.header.stamp = stamp_of(self._gazebo.advance())
        answer.header.frame_id = request.reference_frame or "world"
        try:
            place, speed = self._around.where(request.name)
            if request.reference_frame not in WORLD:
                base, drift = self._around.where(request.reference_frame)
                relative = [one - other for one, other in zip(speed, drift, strict=True)]
                place, speed = base.inverse() @ place, _turned(relative, -base.theta)
        except LookupError as error:
            self._node.get_logger().error(f"GetEntityState: {error.args[0]}")
            return answer
        answer.state = _state(request.name, place, speed, request.reference_frame)
        answer.success = True
        return answer

    def _set(self, request: SetEntityState.Request, answer: SetEntityState.Response) -> SetEntityState.Response:
        state = request.state
        speed = (state.twist.linear.x, state.twist.linear.y, state.twist.angular.z)
        try:
            self._gazebo.advance()
            base = self._around.frame(state.reference_frame)
            place = base @ planar_pose(state.pose)
            if not all(map(math.isfinite, (*place, *speed))):
                raise LookupError("pose and twist must be finite numbers")
            self._gazebo.simulation.put(state.name, place, _turned(speed, base.theta))
        except LookupError as error:
            self._node.get_logger().error(f"SetEntityState: {error.args[0]}")
            return answer
        answer.success = True
        return answer

    def _joints(
        self, request: SetModelConfiguration.Request, answer: SetModelConfiguration.Response
    ) -> SetModelConfiguration.Response:
        robot = self._gazebo.simulation.robots.get(request.model_name)
        if robot is None:
            answer.status_message = f"set_joint_positions: model [{request.model_name}] does not exist"
            return answer
        if len(request.joint_names) != len(request.joint_positions):
            answer.status_message = "set_joint_positions: joint names and positions differ in number"
            return answer
        for name, position in zip(request.joint_names, request.joint_positions, strict=True):
            robot.motors.put(name, position)
        answer.success, answer.status_message = True, "set_joint_positions: success"
        return answer

    def _tell(self) -> None:
        self._publish(self._models, ModelStates, self._around.models())
        if self._links is not None:
            self._publish(self._links, LinkStates, self._around.links())

    def _publish(self, publisher: Publisher, kind: type[Any], names: list[str]) -> None:
        if not publisher.get_subscription_count():
            return
        self._gazebo.advance()
        now = map(self._around.where, names)
        states = [_state(name, place, speed, "") for name, (place, speed) in zip(names, now, strict=True)]
        publisher.publish(kind(name=names, pose=[state.pose for state in states], twist=[state.twist for state in states]))


def _turned(speed: Sequence[float], theta: float) -> Speed:
    c, s = math.cos(theta), math.sin(theta)
    return c * speed[0] - s * speed[1], s * speed[0] + c * speed[1], speed[2]


def _state(name: str, place: Pose2D, speed: Sequence[float], frame: str) -> EntityState:
    pose, twist = Pose(orientation=heading(place.theta)), Twist()
    pose.position.x, pose.position.y = place.x, place.y
    twist.linear.x, twist.linear.y, twist.angular.z = speed
    return EntityState(name=name, pose=pose, twist=twist, reference_frame=frame)


__all__ = ["States"]
