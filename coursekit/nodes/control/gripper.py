"""position_controllers/GripperActionController: opens and closes one joint."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from control_msgs.action import GripperCommand
from rclpy.action import ActionServer, CancelResponse, GoalResponse
from rclpy.task import Future

from .controller import ControlError, Controller

if TYPE_CHECKING:
    from rclpy.action.goal_handle import ServerGoalHandle


class GripperActionController(Controller):
    """Moves to a position; `stalled` means that it pushes without moving."""

    def configure(self) -> None:
        """Read parameters, create the action."""
        self.joint = self.parameter("joint", "")
        if not self.joint:
            raise ControlError("Could not find joint name on param server")
        self._tolerance = float(self.parameter("goal_tolerance", 0.01))
        self._allow_stall = bool(self.parameter("allow_stalling", False))
        self._slow = float(self.parameter("stall_velocity_threshold", 0.001))
        self._patience = float(self.parameter("stall_timeout", 1.0))
        self.parameter("max_effort", 0.0)
        self.parameter("action_monitor_rate", 20.0)
        self._active = False
        self._done: Future | None = None
        self._target = self._effort = 0.0
        self._moved_ns = 0
        self._handle: Any = None
        self._server = ActionServer(
            self.node, GripperCommand, "~/gripper_cmd", self._execute, goal_callback=self._wanted,
            cancel_callback=self._cancel,
        )  # fmt: skip

    def command_names(self) -> list[str]:
        """Return the position command."""
        return [f"{self.joint}/position"]

    def state_names(self) -> list[str]:
        """Return the position and velocity states."""
        return [f"{self.joint}/position", f"{self.joint}/velocity"]

    def activate(self) -> None:
        """Hold the current position."""
        self._target = self.interfaces.state(f"{self.joint}/position")
        self._active = True

    def deactivate(self) -> None:
        """Abort the current goal."""
        self._active = False
        self._finish("abort", False)

    def _wanted(self, _goal: GripperCommand.Goal) -> GoalResponse:
        self.log.info("Received & accepted new action goal" if self._active else "Controller is not running")
        return GoalResponse.ACCEPT if self._active else GoalResponse.REJECT

    def _cancel(self, _handle: ServerGoalHandle) -> CancelResponse:
        self._target = self.interfaces.state(f"{self.joint}/position")
        self._finish("canceled", False)
        return CancelResponse.ACCEPT

    async def _execute(self, handle: ServerGoalHandle) -> Any:
        self._finish("abort", False)
        done = self._done = Future(executor=self.node.executor)
        self._handle = handle
        self._target, self._effort = handle.request.command.position, handle.request.command.max_effort
        self._moved_ns = self.now_ns
        how, result = await done
        getattr(handle, how)()
        return result

    def update(self, now_ns: int, dt: float) -> None:
        """Move on, and check whether the goal is reached."""
        self.interfaces.command(f"{self.joint}/position", self._target)
        if self._done is None:
            return
        at, speed = (self.interfaces.state(f"{self.joint}/{kind}") for kind in ("position", "velocity"))
        if abs(self._target - at) < self._tolerance:
            self._finish("succeed", False)
        elif abs(speed) > self._slow:
            self._moved_ns = now_ns
        elif (now_ns - self._moved_ns) * 1e-9 > self._patience:
            self.log.debug("Stall detected")
            self._finish("succeed" if self._allow_stall else "abort", True)
        else:
            feedback = GripperCommand.Feedback(position=at, effort=self._effort)
            self._handle.publish_feedback(feedback)

    def _finish(self, how: str, stalled: bool) -> None:
        done, self._done = self._done, None
        if done is not None:
            at = self.interfaces.state(f"{self.joint}/position")
            reached = abs(self._target - at) < self._tolerance
            told = GripperCommand.Result(position=at, effort=self._effort, stalled=stalled, reached_goal=reached)
            done.set_result((how, told))

    def close(self) -> None:
        """Destroy the action too."""
        self._finish("abort", False)
        if hasattr(self, "_server"):
            self._server.destroy()
        super().close()


__all__ = ["GripperActionController"]
