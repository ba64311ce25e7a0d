"""pid_controller/PidController: commands of joints from the errors of their states, for topics and other controllers."""

from __future__ import annotations

import math
from typing import Any

from control_msgs.msg import MultiDOFCommand, MultiDOFStateStamped, SingleDOFState
from std_srvs.srv import SetBool

from .controller import ControlError, Controller, stamp
from .pid import Gains, Pid

_KINDS = ("position", "velocity", "acceleration", "effort")


class PidController(Controller):
    """One loop for each degree of freedom; of two interfaces, the second is the first one's derivative."""

    chainable = True

    def configure(self) -> None:
        """Read parameters, create topics and the service."""
        self._read_names()
        self._external = bool(self.parameter("use_external_measured_states", False))
        self._loops = [Pid(self._gains(joint)) for joint in self._joints]
        self._forward = [float(self._gain(joint, "feedforward_gain")) for joint in self._joints]
        self._wraps = [bool(self.parameter(f"gains.{joint}.angle_wraparound", False)) for joint in self._joints]
        name = self.node.get_name()
        self.references = {f"{name}/{joint}/{kind}": math.nan for kind in self._kinds for joint in self._felt}
        self._measured = [math.nan] * len(self.references)
        self._feeds_forward = False
        self._connect()
        self.log.info("configure successful")

    def _read_names(self) -> None:
        self._joints = self._names("dof_names")
        self._felt = self.parameter("reference_and_state_dof_names", []) or self._joints
        if len(self._felt) != len(self._joints):
            raise ControlError(
                f"Size of 'dof_names' ({len(self._joints)}) and 'reference_and_state_dof_names' ({len(self._felt)}) "
                "parameters has to be the same!"
            )
        self._command = str(self.parameter("command_interface", ""))
        self._kinds = self._names("reference_and_state_interfaces")
        for kind in (self._command, *self._kinds):
            if kind not in _KINDS:
                raise ControlError(f"interface '{kind}' is not one of {', '.join(_KINDS)}")
        if len(self._kinds) > 2:
            raise ControlError("'reference_and_state_interfaces' has more than two names: give one, and its derivative")

    def _names(self, parameter: str) -> list[str]:
        names: list[str] = self.parameter(parameter, [])
        if not names:
            raise ControlError(f"'{parameter}' parameter was empty")
        return names

    def _gain(self, joint: str, name: str) -> Any:
        return self.parameter(f"gains.{joint}.{name}", 0.0)

    def _gains(self, joint: str) -> Gains:
        p, i, d, highest, lowest = (self._gain(joint, name) for name in ("p", "i", "d", "i_clamp_max", "i_clamp_min"))
        return Gains(p, i, d, highest, lowest, bool(self.parameter(f"gains.{joint}.antiwindup", False)))

    def _connect(self) -> None:
        self.node.create_subscription(MultiDOFCommand, "~/reference", self._hear_reference, 10)
        if self._external:
            self.node.create_subscription(MultiDOFCommand, "~/measured_state", self._hear_state, 10)
        self.node.create_service(SetBool, "~/set_feedforward_control", self._set_forward)
        self._told = self.node.create_publisher(MultiDOFStateStamped, "~/controller_state", 10)

    def _set_forward(self, request: SetBool.Request, answer: SetBool.Response) -> SetBool.Response:
        self._feeds_forward, answer.success = request.data, True
        return answer

    def _hear_reference(self, msg: MultiDOFCommand) -> None:
        if not self.chained and (values := self._heard(msg, "reference")):
            self.references.update(zip(self.references, values, strict=True))

    def _hear_state(self, msg: MultiDOFCommand) -> None:
        self._measured = self._heard(msg, "measured state") or self._measured

    def _heard(self, msg: MultiDOFCommand, what: str) -> list[float]:
        """Return a message's numbers in the order of the references; none, with a log message, if it is not complete."""
        rows = [list(msg.values), list(msg.values_dot)][: len(self._kinds)]
        if sorted(msg.dof_names) != sorted(self._felt) or len(rows[0]) != len(self._felt):
            self.log.error(f"{what}: has {list(msg.dof_names)} with {len(rows[0])} values; it needs {self._felt}, one each")
            return []
        places = [list(msg.dof_names).index(joint) for joint in self._felt]
        return [row[place] if place < len(row) else math.nan for row in rows for place in places]

    def command_names(self) -> list[str]:
        """Return one command for each degree of freedom."""
        return [f"{joint}/{self._command}" for joint in self._joints]

    def state_names(self) -> list[str]:
        """Return the states that are compared with the references; none if a topic has them."""
        return [] if self._external else [f"{joint}/{kind}" for kind in self._kinds for joint in self._felt]

    def activate(self) -> None:
        """Forget earlier references and errors."""
        self.references.update(dict.fromkeys(self.references, math.nan))
        for loop in self._loops:
            loop.reset()
        self.log.info("activate successful")

    def update(self, now_ns: int, dt: float) -> None:
        """Command what has a reference and a state; publish all loops."""
        if not self._external:
            self._measured = list(map(self.interfaces.state, self.state_names()))
        message = MultiDOFStateStamped()
        message.header.stamp = stamp(now_ns)
        pairs = list(zip(self.references.values(), self._measured, strict=True))
        for number, joint in enumerate(self._joints):
            message.dof_states.append(self._step(number, joint, pairs[number :: len(self._joints)], dt))
        self._told.publish(message)

    def _step(self, number: int, joint: str, pairs: list[tuple[float, float]], dt: float) -> SingleDOFState:
        """Command one joint; the pairs are its reference and its state, and those of the derivative if it has them."""
        (reference, feedback), (goal_rate, rate) = [*pairs, (math.nan, math.nan)][:2]
        told = SingleDOFState(name=joint, reference=reference, feedback=feedback, time_step=dt, output=math.nan)
        if not math.isfinite(reference - feedback):
            return told
        told.error = self._difference(number, reference, feedback)
        error_rate = None
        if math.isfinite(goal_rate - rate):
            told.feedback_dot, told.error_dot = rate, goal_rate - rate
            error_rate = told.error_dot
        ahead = reference * self._forward[number] if self._feeds_forward else 0.0
        told.output = ahead + self._loops[number].command(told.error, dt, error_rate)
        self.interfaces.command(f"{joint}/{self._command}", told.output)
        return told

    def _difference(self, number: int, reference: float, state: float) -> float:
        wraps = self._wraps[number]
        return math.remainder(reference - state, math.tau) if wraps else reference - state


__all__ = ["PidController"]
