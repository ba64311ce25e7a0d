"""Three parameter callbacks: for an own parameter, for another node's, and for whole events."""

from __future__ import annotations

import re
from typing import Any

import rclpy
from rclpy.parameter import Parameter
from rclpy.parameter_event_handler import ParameterEventHandler

from coursekit.nodes.cpp_node import CppNode
from coursekit.nodes.demo_nodes.own_parameters import in_cpp
from coursekit.nodes.running import spin_to_the_end

NODE, OWN = "this_node", "an_int_param"
REMOTE, THEIRS = "/a_namespace/a_remote_node", "a_string_param"
_TYPES = {Parameter.Type.INTEGER: "integer", Parameter.Type.STRING: "string", Parameter.Type.BOOL: "bool"}
_TOLD = f"""\
This demo is monitoring for the following parameter changes:

\tnode: "{NODE}"
\tparameter: "{OWN}"

\tnode: "{REMOTE}"
\tparameter: "{THEIRS}"

To activate the callbacks, from a separate shell/console window, execute either of the following example commands:

\t$ ros2 param set {NODE} {OWN} 21
\t$ ros2 param set {REMOTE} {THEIRS} "string value to set"
"""


class Watcher(CppNode):
    """Has an own parameter, and watches it and another node's."""

    def __init__(self) -> None:
        super().__init__(NODE)
        self.declare_parameter(OWN, 0)
        self._handler = ParameterEventHandler(self)
        self._handler.add_parameter_callback(OWN, NODE, lambda parameter: self._tell("cb1", parameter, " of type"))
        self._handler.add_parameter_callback(THEIRS, REMOTE, lambda parameter: self._tell("cb2", parameter, " of type:"))
        self._handler.add_parameter_event_callback(self._hear)

    def _hear(self, event: Any) -> None:
        if re.fullmatch("(/a_namespace/.*)|(/this_node)", event.node):
            if changed := self._handler.get_parameter_from_event(event, THEIRS, REMOTE):
                self._tell("cb3", changed, " of type:")
            for parameter in self._handler.get_parameters_from_event(event):
                self._tell("cb3", parameter, " of type:")

    def _tell(self, who: str, message: Any, of_type: str) -> None:
        parameter = Parameter.from_parameter_msg(message)
        kind = _TYPES.get(parameter.type_, parameter.type_.name.lower())
        text = f'Received an update to parameter "{parameter.name}"{of_type} {kind}: "{in_cpp(parameter.value)}"'
        self.get_logger().info(f"{who}: {text}")


def main(args: list[str] | None = None) -> int:
    """Watch until Ctrl-C."""
    rclpy.init(args=args)
    space, _, name = REMOTE.rpartition("/")
    remote = CppNode(name, namespace=space)
    remote.declare_parameter(THEIRS, "default_string_value")
    print(_TOLD)
    return spin_to_the_end(Watcher(), remote)
