"""A node's parameters: the right control for each, and refused values with the node's reason."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import yaml

from coursekit.cli.api import full_name
from coursekit.cli.param_text import type_name
from coursekit.suggestions import did_you_mean
from coursekit.words.gettext import gettext

from .errors import NotThere
from .panel import Panel, static
from .panel_node import appears

if TYPE_CHECKING:
    from rclpy.task import Future

_CONTROLS = {1: "check", 2: "whole", 3: "number", 4: "text"}


@dataclass
class Row:
    """One parameter as described by the node."""

    name: str
    kind: int
    value: Any
    descriptor: Any

    def limits(self) -> dict[str, Any]:
        """Return minimum, maximum and step, if the node gave a range."""
        ranges = [*self.descriptor.integer_range, *self.descriptor.floating_point_range]
        if not ranges:
            return {}
        bounds = ranges[0]
        return {"least": bounds.from_value, "greatest": bounds.to_value, **({"step": bounds.step} if bounds.step else {})}

    def written(self) -> str:
        """Return the value as a user would type it."""
        if self.kind > 4:
            return yaml.safe_dump(list(self.value), default_flow_style=True, width=10**6).strip()
        return str(self.value).lower() if self.kind == 1 else str(self.value)


class ParameterPanel(Panel):
    """See `parameter_panel`."""

    _esm = static("parameters.js")
    _css = static("parameters.css")

    def __init__(self, node: str) -> None:
        from rcl_interfaces.msg import ParameterEvent
        from rclpy.parameter_client import AsyncParameterClient
        from rclpy.qos import qos_profile_parameter_events

        super().__init__("parameter_panel")
        self.node_name = full_name(node)
        self._rows: dict[str, Row] = {}
        try:
            self._check_node()
            self._client = AsyncParameterClient(self.hidden.node, self.node_name)
            self.hidden.node.create_subscription(
                ParameterEvent, "/parameter_events", self._follow, qos_profile_parameter_events
            )
            self._read(self.hidden.result(self._client.list_parameters()).result.names)
        except BaseException:
            self.close()
            raise

    def _check_node(self) -> None:
        appears(lambda: any(node.full_name == self.node_name for node in list(self.hidden.graph.nodes)))
        names = sorted(node.full_name for node in list(self.hidden.graph.nodes) if not node.name.startswith("_"))
        if self.node_name not in names:
            hint = did_you_mean(self.node_name, names, f"Nodes are: {', '.join(names) or 'none'}.")
            raise NotThere(f"There is no node {self.node_name}. {hint}")

    def _read(self, names: list[str]) -> None:
        """Request values and descriptors, and wait for them."""
        wanted = sorted(names)
        values = self.hidden.result(self._client.get_parameters(wanted)).values
        descriptors = self.hidden.result(self._client.describe_parameters(wanted)).descriptors
        for name, value, descriptor in zip(wanted, values, descriptors, strict=True):
            self._keep(name, value, descriptor)

    def _keep(self, name: str, value: Any, descriptor: Any) -> None:
        from rclpy.parameter import parameter_value_to_python

        plain = parameter_value_to_python(value)
        self._rows[name] = Row(name, value.type, plain, descriptor)

    # -- from code

    @property
    def values(self) -> dict[str, Any]:
        """The current parameters by name."""
        return {name: self._rows[name].value for name in sorted(self._rows)}

    def set(self, name: str, value: Any) -> bool:
        """Set a parameter and print the result. Returns whether the node accepted it."""
        result = self.hidden.result(self._client.set_parameters([self._parameter(name, value)])).results[0]
        reason = f": {result.reason}" if result.reason else ""
        print(f"{name} = {value}" if result.successful else gettext(f"{self.node_name} refused {name} = {value}{reason}"))
        return bool(result.successful)

    def _parameter(self, name: str, value: Any, typed: bool = False) -> Any:
        """Build the parameter message; its type is inferred from the value, or the declared one (`typed`)."""
        from rclpy.parameter import Parameter

        if name not in self._rows:
            hint = did_you_mean(name, self._rows, f"It has: {', '.join(sorted(self._rows))}")
            raise NotThere(f"{self.node_name} has no parameter '{name}'. {hint}")
        own = Parameter.Type(self._rows[name].kind) if typed or value == [] else None
        return Parameter(name, own, value)

    # -- following

    def _follow(self, event: Any) -> None:
        if event.node != self.node_name:
            return
        for parameter in [*event.new_parameters, *event.changed_parameters]:
            known = self._rows.get(parameter.name)
            if known is not None:
                self._keep(parameter.name, parameter.value, known.descriptor)
            else:
                self._meet(parameter)
        for parameter in event.deleted_parameters:
            self._rows.pop(parameter.name, None)
        self.changed()

    def _meet(self, parameter: Any) -> None:
        """Handle a newly declared parameter: request its descriptor, then show it."""

        def described(future: Future) -> None:
            self._keep(parameter.name, parameter.value, future.result().descriptors[0])
            self.changed()

        self._client.describe_parameters([parameter.name], callback=described)

    # -- what is shown

    def text(self) -> str:
        """A line for each parameter."""
        lines = [f"parameters of {self.node_name}: {len(self._rows)}"]
        for row in (self._rows[name] for name in sorted(self._rows)):
            limits = row.limits()
            span = f"  {limits['least']} .. {limits['greatest']}" if limits else ""
            lock = "  read-only" if row.descriptor.read_only else ""
            lines.append(f"{row.name} ({type_name(row.kind)}): {row.written()}{span}{lock}")
        return "\n".join(lines)

    def shown(self) -> dict[str, Any]:
        """The rows."""
        return {
            "node": self.node_name,
            "rows": [
                {
                    "name": row.name,
                    "type": type_name(row.kind),
                    "control": _CONTROLS.get(row.kind, "list"),
                    "value": row.value if row.kind == 1 else row.written(),
                    "description": row.descriptor.description,
                    "locked": bool(row.descriptor.read_only),
                    **row.limits(),
                }
                for row in (self._rows[name] for name in sorted(self._rows))
            ],
        }

    def on_set(self, message: dict[str, Any]) -> None:
        """Handle a changed control."""
        name = str(message.get("name", ""))
        row = self._rows.get(name)
        if row is None:
            return
        try:
            parameter = self._parameter(name, _typed(row, message.get("value")), typed=True)
        except (ValueError, TypeError, yaml.YAMLError):
            self._refuse(name, gettext(f"'{message.get('value')}' is no {type_name(row.kind)}"))
            return
        self._client.set_parameters([parameter], callback=lambda future: self._was_set(name, future))

    def _was_set(self, name: str, future: Future) -> None:
        result = future.result().results[0]
        if result.successful:
            self.tell(type="accepted", name=name)
        else:
            self._refuse(name, result.reason or "refused")

    def _refuse(self, name: str, reason: str) -> None:
        self.tell(type="refused", name=name, reason=reason)
        self._push()  # resets the control to the node's value


def _typed(row: Row, value: Any) -> Any:
    """Convert the control's value to the parameter's type."""
    if row.kind == 1:
        return bool(value)
    if row.kind in (2, 3):
        return int(value) if row.kind == 2 else float(value)
    if row.kind == 4:
        return str(value)
    values = yaml.safe_load(str(value))
    if not isinstance(values, list):
        raise ValueError(value)
    return [float(value) for value in values] if row.kind == 8 else values


def parameter_panel(node: str) -> ParameterPanel:
    """Show a node's parameters and let the user set them; changes by other nodes are followed.

    LookupError: there is no such node; TimeoutError: it does not spin, so it cannot answer.

    >>> %ros2 run turtlesim turtlesim_node &
    [turtlesim_node: running]
    >>> panel = parameter_panel("/turtlesim")
    >>> panel.set("background_r", 200)
    background_r = 200
    True
    >>> panel.values["background_r"]
    200

    In ROS 2: `ros2 param list|get|set|describe`, or rqt's dynamic reconfigure.
    """
    return ParameterPanel(node)


__all__ = ["ParameterPanel", "parameter_panel"]
