"""Controllers that forward numbers: a topic with one number for each joint."""

from __future__ import annotations

from std_msgs.msg import Float64MultiArray

from .controller import ControlError, Controller


class ForwardCommandController(Controller):
    """forward_command_controller/ForwardCommandController; the groups of one kind fix `interface`."""

    interface = ""

    def configure(self) -> None:
        """Read the joints and their interface."""
        joints = self.parameter("joints", [])
        kind = self.interface or self.parameter("interface_name", "")
        if not joints:
            raise ControlError("'joints' parameter was empty")
        if not kind:
            raise ControlError("'interface_name' parameter was empty")
        self._names = [f"{joint}/{kind}" for joint in joints]
        self._stops = self.interface in ("velocity", "effort")
        self._listen()

    def _listen(self) -> None:
        self._wanted: list[float] | None = None
        self.node.create_subscription(Float64MultiArray, "~/commands", self._hear, 10)
        self.log.info("configure successful")

    def _hear(self, msg: Float64MultiArray) -> None:
        if len(msg.data) != len(self._names):
            self.log.error(
                f"command size ({len(msg.data)}) does not match number of interfaces ({len(self._names)})",
                throttle_duration_sec=1.0,
            )
            return
        self._wanted = list(msg.data)

    def command_names(self) -> list[str]:
        """Return one command for each joint."""
        return self._names

    def activate(self) -> None:
        """Discard earlier commands."""
        self._wanted = None
        self.log.info("activate successful")

    def deactivate(self) -> None:
        """Stop velocities and efforts."""
        self._wanted = None
        for name in self._names if self._stops else ():
            self.interfaces.command(name, 0.0)

    def update(self, now_ns: int, dt: float) -> None:
        """Forward the commands."""
        for name, value in zip(self._names, self._wanted or (), strict=False):
            self.interfaces.command(name, value)


class MultiInterfaceForwardCommandController(ForwardCommandController):
    """forward_command_controller/MultiInterfaceForwardCommandController: several numbers of one joint."""

    def configure(self) -> None:
        """Read the joint and its interfaces."""
        joint, kinds = self.parameter("joint", ""), self.parameter("interface_names", [])
        if not joint:
            raise ControlError("'joint' parameter is empty")
        if not kinds:
            raise ControlError("'interfaces' parameter is empty")
        self._names, self._stops = [f"{joint}/{kind}" for kind in kinds], False
        self._listen()


class PositionGroup(ForwardCommandController):
    """position_controllers/JointGroupPositionController."""

    interface = "position"


class VelocityGroup(ForwardCommandController):
    """velocity_controllers/JointGroupVelocityController."""

    interface = "velocity"


class EffortGroup(ForwardCommandController):
    """effort_controllers/JointGroupEffortController."""

    interface = "effort"


__all__ = [
    "EffortGroup", "ForwardCommandController", "MultiInterfaceForwardCommandController", "PositionGroup", "VelocityGroup",
]  # fmt: skip
