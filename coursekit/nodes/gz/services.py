"""The world's services in the newer Gazebo: create, remove, set_pose and control."""

from __future__ import annotations

from typing import Any

from geometry_msgs.msg import TransformStamped
from ros_gz_interfaces.srv import ControlWorld, DeleteEntity, SetEntityPose, SpawnEntity
from tf2_msgs.msg import TFMessage

from coursekit.files import read_text
from coursekit.nodes.gazebo.entity_poses import planar_pose
from coursekit.nodes.gazebo.model_conversion import renamed
from coursekit.nodes.gazebo.model_paths import find_model
from coursekit.nodes.gazebo.sdf_world import read_entity
from coursekit.nodes.gazebo.sensor_publishers import heading, stamp_of
from coursekit.sim import WorldError
from coursekit.urdf import UrdfError

_STEP_S = 0.001
"""One step of a paused world, the default `max_step_size`."""


class GzServices:
    """A world's services, in Gazebo's own graph."""

    def __init__(self, gazebo: Any, world: str) -> None:
        self._gazebo, self._around, self._world = gazebo, gazebo.around, world
        for kind, name, answer in (
            (SpawnEntity, "create", self._create), (DeleteEntity, "remove", self._remove),
            (SetEntityPose, "set_pose", self._set_pose), (ControlWorld, "control", self._control),
        ):  # fmt: skip
            gazebo.create_service(kind, f"/world/{world}/{name}", answer)

    def _create(self, request: Any, answer: Any) -> Any:
        wish = request.entity_factory
        try:
            text, file = wish.sdf, None
            if wish.sdf_filename:
                file = find_model(wish.sdf_filename)
                text = read_text(file)
            model = read_entity(text, "", file, self._world, wish.name)
            name = wish.name or model.name
            if name in self._around.models():
                if not wish.allow_renaming:
                    raise WorldError(f"there is a '{name}' already", cure="Give it another -name, or -allow_renaming true.")
                name = self._free(name)
            self._gazebo.put(renamed(model, name, self._around.frame("") @ planar_pose(wish.pose)))
        except (UrdfError, WorldError, OSError, UnicodeDecodeError) as error:
            self._gazebo.get_logger().error(f"Error creating an entity: {error}")
            return answer
        self._around.deleted.discard(name)
        answer.success = True
        return answer

    def _free(self, name: str) -> str:
        taken, number = self._around.models(), 1
        while f"{name}_{number}" in taken:
            number += 1
        return f"{name}_{number}"

    def _remove(self, request: Any, answer: Any) -> Any:
        name = request.entity.name
        if name not in self._around.models():
            self._gazebo.get_logger().error(f"Entity named [{name}] of type [{request.entity.type}] not found")
            return answer
        self._gazebo.delete(name)
        answer.success = True
        return answer

    def _set_pose(self, request: Any, answer: Any) -> Any:
        self._gazebo.advance()
        try:
            self._gazebo.simulation.put(request.entity.name, planar_pose(request.pose))
        except LookupError as error:
            self._gazebo.get_logger().error(str(error.args[0]))
            return answer
        answer.success = True
        return answer

    def _control(self, request: Any, answer: Any) -> Any:
        wish = request.world_control
        if wish.reset.all or wish.reset.time_only or wish.reset.model_only:
            self._gazebo.restart(not wish.reset.model_only)
        if steps := wish.multi_step or int(wish.step):
            self._gazebo.step(steps * _STEP_S)
        else:
            self._gazebo.pause(wish.pause)
        answer.success = True
        return answer

    def poses(self) -> TFMessage:
        """Return the poses of all models."""
        msg, stamp = TFMessage(), stamp_of(self._gazebo.simulation.now_ns)
        for name in self._around.models():
            place, _ = self._around.where(name)
            transform = TransformStamped(child_frame_id=name)
            transform.header.stamp, transform.header.frame_id = stamp, self._world
            transform.transform.translation.x, transform.transform.translation.y = place.x, place.y
            transform.transform.rotation = heading(place.theta)
            msg.transforms.append(transform)
        return msg


__all__ = ["GzServices"]
