"""gazebo_ros_force_system: services that apply forces to links and efforts to joints for a time."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from gazebo_msgs.srv import ApplyJointEffort, ApplyLinkWrench, JointRequest, LinkRequest

from coursekit.geometry.plane import Pose2D
from coursekit.sim.external_forces import ExternalForce

from .entity_poses import WORLD

if TYPE_CHECKING:
    from coursekit.nodes.gazebo.server import Gazebo


class Forces:
    """The services of a simulator's node."""

    def __init__(self, gazebo: Gazebo) -> None:
        self._gazebo, self._log = gazebo, gazebo.get_logger()
        gazebo.create_service(ApplyLinkWrench, "apply_link_wrench", self._push)
        gazebo.create_service(LinkRequest, "clear_link_wrenches", lambda asked, answer: self._end(asked.link_name, answer))
        gazebo.create_service(ApplyJointEffort, "apply_joint_effort", self._turn)
        gazebo.create_service(JointRequest, "clear_joint_efforts", lambda asked, answer: self._end(asked.joint_name, answer))

    def _push(self, request: ApplyLinkWrench.Request, answer: ApplyLinkWrench.Response) -> ApplyLinkWrench.Response:
        now, around = self._gazebo.advance(), self._gazebo.around
        try:
            if "::" not in request.link_name:
                raise LookupError(f"entity [{request.link_name}] is no link. Say model::link.")
            link = around.where(request.link_name)[0]
        except LookupError as error:
            self._log.error(f"Link [{request.link_name}] does not exist: {error.args[0]}")
            answer.status_message = "ApplyLinkWrench: link does not exist"
            return answer
        try:
            base = around.frame(request.reference_frame)
        except LookupError as error:
            self._log.error(f"Reference_frame is not a valid entity name: {error.args[0]}")
            answer.status_message = "Reference_frame not found"
            return answer
        model = request.link_name.partition("::")[0]
        if request.reference_frame in WORLD:
            base = Pose2D(link.x, link.y, 0.0)
        at = base @ Pose2D(request.reference_point.x, request.reference_point.y, 0.0)
        force = Pose2D(0.0, 0.0, base.theta) @ Pose2D(request.wrench.force.x, request.wrench.force.y, 0.0)
        body = self._gazebo.simulation.pose_of(model)
        lever = (at.x - body.x) * force.y - (at.y - body.y) * force.x
        torque, times = request.wrench.torque.z + lever, _times(request, now)
        push = ExternalForce(model, force.x, force.y, torque, *times, label=request.link_name)
        return self._begin(push, answer, "")

    def _turn(self, request: ApplyJointEffort.Request, answer: ApplyJointEffort.Response) -> ApplyJointEffort.Response:
        now, name = self._gazebo.advance(), request.joint_name
        for robot in self._gazebo.simulation.robots.values():
            drive = robot.model.drive
            if drive is None or name not in (*drive.left, *drive.right):
                continue
            force = request.effort / drive.radius
            arm = drive.separation / 2 * (-1.0 if name in drive.left else 1.0)
            push = ExternalForce(robot.name, force, 0.0, force * arm, *_times(request, now), along=True, label=name)
            return self._begin(push, answer, f"Effort on joint [{name}] set")
        answer.status_message = "Joint not found"
        self._log.error(f"Joint [{name}] is no wheel of a robot; efforts on other joints are not simulated")
        return answer

    def _begin(self, push: ExternalForce, answer: ApplyLinkWrench.Response | ApplyJointEffort.Response, text: str) -> Any:
        if not push.finite:
            answer.status_message = "force and torque must be finite numbers"
            return answer
        self._gazebo.simulation.pushes.append(push)
        answer.success, answer.status_message = True, text
        return answer

    def _end(self, label: str, answer: LinkRequest.Response | JointRequest.Response) -> Any:
        self._gazebo.advance()
        pushes = self._gazebo.simulation.pushes
        kept = [push for push in pushes if push.label != label]
        if len(kept) == len(pushes):
            self._log.warning(f"No applied wrenches or efforts on [{label}]")
        pushes[:] = kept
        return answer


def _times(request: ApplyLinkWrench.Request | ApplyJointEffort.Request, now: int) -> tuple[int, int | None]:
    """Return the start and end [ns]; None for no end."""
    begin = max(now, request.start_time.sec * 10**9 + request.start_time.nanosec)
    long = request.duration.sec * 10**9 + request.duration.nanosec
    return begin, None if long < 0 else begin + long


__all__ = ["Forces"]
