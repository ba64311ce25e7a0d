"""Gazebo's services: spawn and delete, reset and pause, where things are."""

from __future__ import annotations

import math
from typing import Any

from gazebo_msgs.msg import EntityState, ModelStates
from gazebo_msgs.srv import DeleteEntity, GetEntityState, GetModelList, SetEntityState, SetModelConfiguration, SpawnEntity
from geometry_msgs.msg import Pose, Twist
from std_srvs.srv import Empty

from coursekit.sim import Place, WorldError
from coursekit.urdf import UrdfError

from .assembly import renamed
from .outlets import heading, stamp_of
from .sdf_world import read_entity

WORLD = ("", "world", "map", "/map")


class Services:
    """The services of a simulator's node."""

    def __init__(self, node: Any) -> None:
        self._node = node
        self.deleted: set[str] = set()
        make = node.create_service
        make(SpawnEntity, "spawn_entity", self._spawn)
        make(DeleteEntity, "delete_entity", self._delete)
        make(GetModelList, "get_model_list", self._list)
        make(GetEntityState, "get_entity_state", self._get)
        make(SetEntityState, "set_entity_state", self._set)
        make(SetModelConfiguration, "set_joint_positions", self._joints)
        make(Empty, "reset_simulation", lambda _, answer: self._restart(True, answer))
        make(Empty, "reset_world", lambda _, answer: self._restart(False, answer))
        make(Empty, "pause_physics", lambda _, answer: self._pause(True, answer))
        make(Empty, "unpause_physics", lambda _, answer: self._pause(False, answer))
        self._states = node.create_publisher(ModelStates, "model_states", 10)
        node.create_timer(0.1, self._tell_states)

    # -- spawning

    def _spawn(self, request: Any, answer: Any) -> Any:
        answer.success = False
        try:
            model = read_entity(request.xml, request.robot_namespace)
            name = request.name or self._free_name(model.name)
            if name in self._node.models():
                answer.status_message = f"Entity [{name}] already exists."
                return answer
            place = self._in_world(_place(request.initial_pose), request.reference_frame)
            self._node.put(renamed(model, name, place))
        except LookupError as error:
            answer.status_message = f"Reference frame [{request.reference_frame}] not found. {error.args[0]}"
        except (UrdfError, WorldError) as error:
            answer.status_message = str(error)
        else:
            self.deleted.discard(name)
            answer.success = True
            answer.status_message = f"SpawnEntity: Successfully spawned entity [{name}]"
        return answer

    def _free_name(self, name: str) -> str:
        taken, number = self._node.models(), 0
        while (f"{name}_{number}" if number else name) in taken:
            number += 1
        return f"{name}_{number}" if number else name

    def _delete(self, request: Any, answer: Any) -> Any:
        if request.name not in self._node.models():
            answer.success, answer.status_message = False, f"Entity [{request.name}] does not exist"
            return answer
        self._node.advance()
        try:
            self._node.take_out(request.name)
        except LookupError:  # a model in which nothing can be met
            pass
        self.deleted.add(request.name)
        answer.success, answer.status_message = True, f"Successfully deleted entity [{request.name}]"
        return answer

    # -- time

    def _restart(self, time: bool, answer: Any) -> Any:
        self._node.restart(time)
        return answer

    def _pause(self, pause: bool, answer: Any) -> Any:
        self._node.advance()
        (self._node.time.pause if pause else self._node.time.go_on)()
        return answer

    # -- states

    def _list(self, _request: Any, answer: Any) -> Any:
        answer.header.stamp = stamp_of(self._node.advance())
        answer.model_names, answer.success = self._node.models(), True
        return answer

    def _where(self, name: str) -> tuple[Place, tuple[float, float, float]]:
        """Place and velocity of a model or link in the world; LookupError."""
        model, _, link = name.partition("::")
        simulation = self._node.simulation
        places = simulation.world.models
        if model in places and model not in simulation.names() and model not in self.deleted:
            return places[model], (0.0, 0.0, 0.0)
        place, speed = simulation.place_of(model), simulation.velocity_of(model)
        if link:
            frames = self._node.assemblies[model].frames if model in self._node.assemblies else {}
            if link not in frames:
                raise LookupError(f"model '{model}' has no link '{link}'")
            made = frames[link]
            place = place @ Place(float(made[0, 3]), float(made[1, 3]), math.atan2(made[1, 0], made[0, 0]))
        return place, speed

    def _in_world(self, place: Place, frame: str) -> Place:
        return place if frame in WORLD else self._where(frame)[0] @ place

    def _get(self, request: Any, answer: Any) -> Any:
        answer.header.stamp = stamp_of(self._node.advance())
        answer.header.frame_id = request.reference_frame or "world"
        try:
            place, speed = self._where(request.name)
            if request.reference_frame not in WORLD:
                base = self._where(request.reference_frame)[0].inverse()
                place, speed = base @ place, _turned(speed, base.theta)
        except LookupError as error:
            self._node.get_logger().error(f"GetEntityState: {error.args[0]}")
            return answer
        answer.state = _state(request.name, place, speed, request.reference_frame)
        answer.success = True
        return answer

    def _set(self, request: Any, answer: Any) -> Any:
        state = request.state
        speed = (state.twist.linear.x, state.twist.linear.y, state.twist.angular.z)
        try:
            self._node.advance()
            place = self._in_world(_place(state.pose), state.reference_frame)
            if not all(map(math.isfinite, (*place, *speed))):
                raise LookupError("pose and twist must be finite numbers")
            self._node.simulation.put(state.name, place, speed)
        except LookupError as error:
            self._node.get_logger().error(f"SetEntityState: {error.args[0]}")
            return answer
        answer.success = True
        return answer

    def _joints(self, request: Any, answer: Any) -> Any:
        robot = self._node.simulation.robots.get(request.model_name)
        if robot is None:
            answer.status_message = f"SetModelConfiguration: model [{request.model_name}] does not exist"
            return answer
        for name, position in zip(request.joint_names, request.joint_positions, strict=False):
            robot.angles[name] = position
        answer.success, answer.status_message = True, "SetModelConfiguration: success"
        return answer

    def _tell_states(self) -> None:
        if not self._states.get_subscription_count():
            return
        self._node.advance()
        msg = ModelStates(name=self._node.models())
        for name in msg.name:
            state = _state(name, *self._where(name), "")
            msg.pose.append(state.pose)
            msg.twist.append(state.twist)
        self._states.publish(msg)


def _place(pose: Pose) -> Place:
    q = pose.orientation
    return Place(pose.position.x, pose.position.y, math.atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z)))


def _turned(speed: tuple[float, float, float], theta: float) -> tuple[float, float, float]:
    c, s = math.cos(theta), math.sin(theta)
    return c * speed[0] - s * speed[1], s * speed[0] + c * speed[1], speed[2]


def _state(name: str, place: Place, speed: tuple[float, float, float], frame: str) -> EntityState:
    pose, twist = Pose(orientation=heading(place.theta)), Twist()
    pose.position.x, pose.position.y = place.x, place.y
    twist.linear.x, twist.linear.y, twist.angular.z = speed
    return EntityState(name=name, pose=pose, twist=twist, reference_frame=frame)


__all__ = ["Services"]
