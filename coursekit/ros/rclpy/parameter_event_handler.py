"""Callbacks for parameter changes. In ROS 2: rclpy.parameter_event_handler (Iron and later)."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from rcl_interfaces.msg import Parameter, ParameterEvent

from coursekit.rcl import names
from rclpy.qos import QoSProfile, qos_profile_parameter_events

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node


class ParameterCallbackHandle:
    """A callback for one parameter of one node; pass it to `remove_parameter_callback` to remove it."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """A callback for every event; pass it to `remove_parameter_event_callback` to remove it."""

    def __init__(self, callback: Callable[[ParameterEvent], None]) -> None:
        self.callback = callback


class ParameterEventHandler:
    """Runs callbacks when parameters of any node are declared or changed, as reported on `/parameter_events`.

    >>> handler = ParameterEventHandler(node)
    >>> speed = node.declare_parameter("speed", 0.5)
    >>> tell = lambda parameter: print("now", parameter.value.double_value)
    >>> heard = handler.add_parameter_callback("speed", "robot", tell)
    >>> results = node.set_parameters([rclpy.parameter.Parameter("speed", value=1.0)])
    >>> rclpy.spin_once(node)
    now 0.5
    >>> rclpy.spin_once(node)
    now 1.0
    """

    def __init__(
        self,
        node: Node,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> None:
        self.node = node
        self._by_parameter: list[ParameterCallbackHandle] = []
        self._by_event: list[ParameterEventCallbackHandle] = []
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._heard,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )

    def destroy(self) -> None:
        """Destroy the subscription to `/parameter_events`."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]
    ) -> ParameterCallbackHandle:
        """Call `callback(parameter)` when the parameter of the node is declared or changed.

        `node_name` may be absolute, or relative to the namespace of the handler's node.
        """
        handle = ParameterCallbackHandle(parameter_name, self._resolve_path(node_name), callback)
        self._by_parameter.append(handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Remove a callback; ValueError if it does not belong to this handler."""
        self._by_parameter.remove(handle)

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], None]
    ) -> ParameterEventCallbackHandle:
        """Call `callback(event)` for every rcl_interfaces/msg/ParameterEvent."""
        handle = ParameterEventCallbackHandle(callback)
        self._by_event.append(handle)
        return handle

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Remove a callback; ValueError if it does not belong to this handler."""
        self._by_event.remove(handle)

    @staticmethod
    def get_parameter_from_event(
        event: ParameterEvent, parameter_name: str, node_name: str
    ) -> Parameter | None:
        """Return the new or changed parameter of the node in the event, or None."""
        if event.node != node_name:
            return None
        parameters = ParameterEventHandler.get_parameters_from_event(event)
        return next((each for each in parameters if each.name == parameter_name), None)

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterator[Parameter]:
        """Return the new and the changed parameters of the event."""
        yield from event.new_parameters
        yield from event.changed_parameters

    def _heard(self, event: ParameterEvent) -> None:
        for handle in reversed(self._by_parameter):
            parameter = self.get_parameter_from_event(event, handle.parameter_name, handle.node_name)
            if parameter is not None:
                handle.callback(parameter)
        for each in reversed(self._by_event):
            each.callback(event)

    def _resolve_path(self, node_path: str | None = None) -> str:
        """A node's full name; without `node_path`, that of the handler's own node."""
        if not node_path:
            return self.node.get_fully_qualified_name()
        return node_path if node_path.startswith("/") else names.join(self.node.get_namespace(), node_path)
