"""joint_trajectory_controller/JointTrajectoryController: follows trajectories from an action or a topic."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from control_msgs.action import FollowJointTrajectory
from control_msgs.msg import JointTrajectoryControllerState
from control_msgs.srv import QueryTrajectoryState
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.task import Future
from trajectory_msgs.msg import JointTrajectory

from .controller import ControlError, Controller, stamp
from .joint_commands import JointCommands, difference
from .tolerances import Tolerances
from .trajectory import Array, Point, Trajectory
from .trajectory_messages import fault_of, message_of, points_of
from .trajectory_parameters import KINDS, TrajectoryParameters

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle

Result = FollowJointTrajectory.Result


class JointTrajectoryController(Controller):
    """Each step samples the trajectory, commands it, compares, and updates the action."""

    def configure(self) -> None:
        """Read parameters; create the topic, the action and the state publisher."""
        self.told = TrajectoryParameters.of(self)
        self.joints = list(self.told.joints)
        self._open()

    def _open(self) -> None:
        self.active = False
        self.trajectory: Trajectory | None = None
        self._goal: Any = None
        self._done: Future | None = None
        self._told_ns = 0
        self._desired = Point(0.0, np.zeros(len(self.joints)))
        node = self.node
        node.create_subscription(JointTrajectory, "~/joint_trajectory", self._hear, 10)
        kind = JointTrajectoryControllerState
        self._out = [node.create_publisher(kind, f"~/{topic}", 10) for topic in ("state", "controller_state")]
        node.create_service(QueryTrajectoryState, "~/query_state", self._query)
        self._server = ActionServer(
            node, FollowJointTrajectory, "~/follow_joint_trajectory", self._execute,
            goal_callback=self._wanted, cancel_callback=self._cancel,
        )  # fmt: skip

    def command_names(self) -> list[str]:
        """Return the commands, joint by joint."""
        return [f"{joint}/{kind}" for joint in self.told.command_joints for kind in self.told.commands]

    def state_names(self) -> list[str]:
        """Return the states, joint by joint."""
        return [f"{joint}/{kind}" for joint in self.joints for kind in self.told.states]

    # -- inputs

    def _hear(self, msg: JointTrajectory) -> None:
        if not self.active:
            return
        fault = self._fault(msg)
        if fault:
            self.log.error(fault)
            return
        self._follow(msg, self.told.tolerances)

    def _fault(self, msg: JointTrajectory) -> str:
        return fault_of(msg, self.joints, self.told.partial, self.told.moving_end, self.now_ns)

    def _wanted(self, goal: FollowJointTrajectory.Goal) -> GoalResponse:
        self.log.info("Received new action goal")
        if not self.active:
            self.log.error("Can't accept new action goals. Controller is not running.")
            return GoalResponse.REJECT
        fault = self._fault(goal.trajectory)
        if fault:
            self.log.error(fault)
            return GoalResponse.REJECT
        self.log.info("Accepted new action goal")
        return GoalResponse.ACCEPT

    def _cancel(self, handle: ServerGoalHandle) -> CancelResponse:
        self.log.info("Got request to cancel goal")
        if self._goal is not None and bytes(handle.goal_id.uuid) == bytes(self._goal.goal_id.uuid):
            self.log.info("Canceling active action goal because cancel callback received.")
            self.hold()
            self._finish("canceled", Result())
        return CancelResponse.ACCEPT

    async def _execute(self, handle: ServerGoalHandle) -> Any:
        self._preempt()
        done = self._done = Future(executor=self.node.executor)
        self._goal = handle
        self._follow(handle.request.trajectory, self.told.tolerances.asked(handle.request, self.joints))
        how, result = await done
        getattr(handle, {"succeeded": "succeed", "aborted": "abort", "canceled": "canceled"}[how])()
        return result

    def _preempt(self) -> None:
        if self._done is not None:
            self._finish("aborted", Result(error_string="preempted by a newer goal"))

    def _follow(self, msg: JointTrajectory, tolerances: Tolerances) -> None:
        if self._goal is not None and msg is not self._goal.request.trajectory:
            self._preempt()
        now = self._state()
        start_ns = msg.header.stamp.sec * 1_000_000_000 + msg.header.stamp.nanosec or self.now_ns
        begin = self._desired if self.told.open_loop else now
        points = points_of(msg, self.joints, begin.positions)
        self.trajectory = Trajectory(points, start_ns, begin, self.now_ns, self.told.splines)
        self._limits, self._first = tolerances, True

    # -- one step

    def activate(self) -> None:
        """Hold the joints' current positions."""
        self._limits, self._first = self.told.tolerances, False
        self._commands = JointCommands(self.told)
        self._desired = self._state()
        if np.isnan(self._desired.positions).any():
            raise ControlError("the positions of its joints are not known yet")
        self.hold()
        self.active = True

    def deactivate(self) -> None:
        """Stop; abort a goal."""
        self.active = False
        self.trajectory = None
        self._preempt()
        for joint in self.told.command_joints:
            for kind in set(self.told.commands) & {"velocity", "effort"}:
                self.interfaces.command(f"{joint}/{kind}", 0.0)

    def hold(self) -> None:
        """Hold the current positions from now on."""
        now = self._state()
        still = Point(0.0, now.positions, np.zeros_like(now.positions), None)
        self.trajectory = Trajectory([still], self.now_ns, still, self.now_ns)

    def _state(self) -> Point:
        read = self.interfaces.state
        told: list[Array | None] = [
            np.array([read(f"{joint}/{kind}") for joint in self.joints]) if kind in self.told.states else None
            for kind in KINDS[:3]
        ]
        positions, velocities, accelerations = told
        assert positions is not None
        return Point(0.0, positions, velocities, accelerations if velocities is not None else None)

    def update(self, now_ns: int, dt: float) -> None:
        """Follow the trajectory."""
        way = self.trajectory
        if way is None or now_ns < way.begin_ns:
            return
        actual = self._state()
        desired, over = way.sample(now_ns)
        error = difference(desired, actual)
        first, self._first = self._first, False
        violated = (not over or first) and not self._limits.on_path(error.positions, error.velocities)
        missed = over and not self._limits.at_goal(error.positions, error.velocities)
        late = (now_ns - way.end_ns) * 1e-9
        exceeded = missed and self._limits.goal_time > 0.0 and late > self._limits.goal_time
        if not violated and not exceeded:
            self._commands.give(self.interfaces, desired, error, dt)
            self._desired = desired
        self._tell(now_ns, desired, actual, error)
        if self._goal is not None:
            self._judge(violated, over, missed, late if exceeded else 0.0)

    def _judge(self, violated: bool, over: bool, missed: bool, late: float) -> None:
        if violated:
            self.log.warning("Aborted due to state tolerance violation")
            self._abort(Result.PATH_TOLERANCE_VIOLATED, "Aborted due to path tolerance violation")
        elif over and not missed:
            self.log.info("Goal reached, success!")
            self._finish("succeeded", Result(error_code=Result.SUCCESSFUL, error_string="Goal successfully reached!"))
        elif late:
            text = f"Aborted due goal_time_tolerance exceeding by {late:f} seconds"
            self.log.warning(text)
            self._abort(Result.GOAL_TOLERANCE_VIOLATED, text)

    def _abort(self, code: int, text: str) -> None:
        self.hold()
        self._finish("aborted", Result(error_code=code, error_string=text))

    def _finish(self, how: str, result: FollowJointTrajectory.Result) -> None:
        done, self._done, self._goal = self._done, None, None
        if done is not None:
            done.set_result((how, result))

    # -- outputs

    def _tell(self, now_ns: int, desired: Point, actual: Point, error: Point) -> None:
        if self._goal is not None:
            feedback = FollowJointTrajectory.Feedback(joint_names=self.joints)
            feedback.header.stamp = stamp(now_ns)
            feedback.desired, feedback.actual, feedback.error = (message_of(point) for point in (desired, actual, error))
            self._goal.publish_feedback(feedback)
        if now_ns - self._told_ns < self.told.period_ns or not any(
            publisher.get_subscription_count() for publisher in self._out
        ):
            return
        self._told_ns = now_ns
        msg = JointTrajectoryControllerState(joint_names=self.joints)
        msg.header.stamp = stamp(now_ns)
        msg.reference, msg.feedback, msg.error = (message_of(point) for point in (desired, actual, error))
        msg.desired, msg.actual = msg.reference, msg.feedback
        for publisher in self._out:
            publisher.publish(msg)

    def _query(
        self, request: QueryTrajectoryState.Request, answer: QueryTrajectoryState.Response
    ) -> QueryTrajectoryState.Response:
        if not self.active or self.trajectory is None:
            answer.message = "Can't sample trajectory. Controller is not active."
            self.log.error(answer.message)
            return answer
        point, _ = self.trajectory.sample(request.time.sec * 1_000_000_000 + request.time.nanosec)
        answer.success, answer.name, answer.position = True, self.joints, point.positions.tolist()
        answer.velocity = [] if point.velocities is None else point.velocities.tolist()
        answer.acceleration = [] if point.accelerations is None else point.accelerations.tolist()
        return answer

    def close(self) -> None:
        """Destroy the action too."""
        self._preempt()
        if hasattr(self, "_server"):
            self._server.destroy()
        super().close()


__all__ = ["JointTrajectoryController"]
