"""Gazebo's services of the world: spawn and delete, reset and pause."""

from __future__ import annotations

from typing import TYPE_CHECKING

from gazebo_msgs.srv import DeleteEntity, GetModelList, SpawnEntity
from std_srvs.srv import Empty

from coursekit.sim import WorldError
from coursekit.urdf import UrdfError

from .entity_poses import planar_pose
from .model_conversion import renamed
from .sdf_world import read_entity
from .sensor_publishers import stamp_of

if TYPE_CHECKING:
    from coursekit.nodes.gazebo.server import Gazebo


class Services:
    """The services of a simulator's node."""

    def __init__(self, node: Gazebo) -> None:
        self._node, self._around = node, node.around
        make = node.create_service
        make(SpawnEntity, "spawn_entity", self._spawn)
        make(DeleteEntity, "delete_entity", self._delete)
        make(GetModelList, "get_model_list", self._list)
        make(Empty, "reset_simulation", lambda _, answer: self._restart(True, answer))
        make(Empty, "reset_world", lambda _, answer: self._restart(False, answer))
        make(Empty, "pause_physics", lambda _, answer: self._pause(True, answer))
        make(Empty, "unpause_physics", lambda _, answer: self._pause(False, answer))

    # -- spawning

    def _spawn(self, request: SpawnEntity.Request, answer: SpawnEntity.Response) -> SpawnEntity.Response:
        answer.success = False
        try:
            model = read_entity(request.xml, request.robot_namespace, None, self._node.newer, request.name)
            name = request.name or self._free_name(model.name)
            if name in self._around.models():
                answer.status_message = f"Entity [{name}] already exists."
                return answer
            place = self._around.frame(request.reference_frame) @ planar_pose(request.initial_pose)
            self._node.put(renamed(model, name, place))
        except LookupError as error:
            answer.status_message = f"Reference frame [{request.reference_frame}] not found. {error.args[0]}"
        except (UrdfError, WorldError) as error:
            answer.status_message = str(error)
        else:
            self._around.deleted.discard(name)
            answer.success = True
            answer.status_message = f"SpawnEntity: Successfully spawned entity [{name}]"
        return answer

    def _free_name(self, name: str) -> str:
        taken, number = self._around.models(), 0
        while (f"{name}_{number}" if number else name) in taken:
            number += 1
        return f"{name}_{number}" if number else name

    def _delete(self, request: DeleteEntity.Request, answer: DeleteEntity.Response) -> DeleteEntity.Response:
        if request.name not in self._around.models():
            answer.success, answer.status_message = False, f"Entity [{request.name}] does not exist"
            return answer
        self._node.delete(request.name)
        answer.success, answer.status_message = True, f"Successfully deleted entity [{request.name}]"
        return answer

    # -- time

    def _restart(self, time: bool, answer: Empty.Response) -> Empty.Response:
        self._node.restart(time)
        return answer

    def _pause(self, pause: bool, answer: Empty.Response) -> Empty.Response:
        self._node.pause(pause)
        return answer

    def _list(self, _request: GetModelList.Request, answer: GetModelList.Response) -> GetModelList.Response:
        answer.header.stamp = stamp_of(self._node.advance())
        answer.model_names, answer.success = self._around.models(), True
        return answer


__all__ = ["Services"]
