"""Nodes with managed states. In ROS 2: rclpy.lifecycle.node."""

from __future__ import annotations

import traceback
from typing import TYPE_CHECKING, Any

from lifecycle_msgs.msg import TransitionEvent

from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle.managed_entity import ManagedEntity
from rclpy.lifecycle.publisher import LifecyclePublisher
from rclpy.lifecycle.services import LifecycleServices, event_of
from rclpy.lifecycle.state_machine import LifecycleState, StateMachine
from rclpy.lifecycle.state_machine import TransitionCallbackReturnType as TransitionCallbackReturn
from rclpy.node import Node

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup

_CALLBACKS = {
    10: "on_configure",
    11: "on_cleanup",
    12: "on_shutdown",
    13: "on_activate",
    14: "on_deactivate",
    15: "on_error",
}


class LifecycleNodeMixin(ManagedEntity):
    """A managed node: its callbacks pass each transition on to its managed entities."""

    def __init__(self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None) -> None:
        if not isinstance(enable_communication_interface, bool):
            raise TypeError("enable_communication_interface must be a bool")
        self._managed_entities: list[ManagedEntity] = []
        node: Any = self
        self._transition_event_publisher = node.create_publisher(TransitionEvent, "~/transition_event", 10)
        self._state_machine = StateMachine(self._rclpy_tell)
        group = callback_group or node.default_callback_group
        if enable_communication_interface:
            LifecycleServices(node, self._state_machine, self._rclpy_change_if_possible, group)

    def _rclpy_tell(self, start: int, goal: int) -> None:
        self._transition_event_publisher.publish(event_of(start, goal))

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Go from unconfigured to inactive."""
        return self._rclpy_change_state(1)

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Go from inactive to unconfigured."""
        return self._rclpy_change_state(2)

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Go from inactive to active."""
        return self._rclpy_change_state(3)

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Go from active to inactive."""
        return self._rclpy_change_state(4)

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Go from unconfigured, inactive or active to finalized; RCLError from any other state."""
        by_state = {1: 5, 2: 6, 3: 7}
        state = self._state_machine.current_state[0]
        if state not in by_state:
            raise RCLError("Shutdown transtion not possible")
        return self._rclpy_change_state(by_state[state])

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Make the entity follow the node's states; TypeError for anything but a ManagedEntity."""
        if not isinstance(entity, ManagedEntity):
            raise TypeError("Expected a rclpy.lifecycle.ManagedEntity instance.")
        self._managed_entities.append(entity)

    def create_lifecycle_publisher(self, *args: Any, **kwargs: Any) -> LifecyclePublisher:
        """Create a publisher (arguments as create_publisher) that is silent while the node is not active."""
        if "publisher_class" in kwargs:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        node: Any = self
        publisher = node.create_publisher(*args, **kwargs, publisher_class=LifecyclePublisher)
        self._managed_entities.append(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher) -> bool:
        """Destroy a publisher of create_lifecycle_publisher; False if it does not belong to this node."""
        if publisher in self._managed_entities:
            self._managed_entities.remove(publisher)
        node: Any = self
        return node.destroy_publisher(publisher)

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure the managed entities."""
        return self._rclpy_pass_on("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean the managed entities up."""
        return self._rclpy_pass_on("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Shut the managed entities down."""
        return self._rclpy_pass_on("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Activate the managed entities."""
        return self._rclpy_pass_on("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Deactivate the managed entities."""
        return self._rclpy_pass_on("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Report an error to the managed entities."""
        return self._rclpy_pass_on("on_error", state)

    def _rclpy_pass_on(self, callback: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in list(self._managed_entities):
            answer = getattr(entity, callback)(state)
            if answer != TransitionCallbackReturn.SUCCESS:
                return answer
        return TransitionCallbackReturn.SUCCESS

    def _rclpy_change_state(self, transition_id: int) -> TransitionCallbackReturn:
        """Make a transition: run its callback, and on_error if the callback ends with an error.

        Raises:
            RCLError: if the current state has no such transition.
        """
        state_id, label = self._state_machine.current_state
        before = LifecycleState(label, state_id)
        self._state_machine.trigger_transition_by_id(transition_id)
        answer = self._rclpy_call_back(before)
        if answer == TransitionCallbackReturn.ERROR:
            self._rclpy_call_back(before)
        return answer

    def _rclpy_change_if_possible(self, transition_id: int) -> TransitionCallbackReturn:
        """The callback of change_state: an impossible transition is logged and reported to the client, not raised."""
        state = self._state_machine.current_state
        try:
            return self._rclpy_change_state(transition_id)
        except RCLError as error:
            self._rclpy_logger_of().error(f"Unable to start transition {transition_id} from current state {state}: {error}")
            return TransitionCallbackReturn.ERROR

    def _rclpy_call_back(self, before: LifecycleState) -> TransitionCallbackReturn:
        """Run the callback of the current transition state, and leave that state according to the result.

        Raises:
            AttributeError: if the callback returns none of TransitionCallbackReturn's values; Humble ends so, too.
        """
        callback = _CALLBACKS[self._state_machine.current_state[0]]
        try:
            answer: TransitionCallbackReturn = getattr(self, callback)(before)
        except Exception as error:
            self._rclpy_tell_exception(error, f"{callback} raised in state {before.label}")
            answer = TransitionCallbackReturn.ERROR
        self._state_machine.trigger_transition_by_label(answer.to_label())
        return answer

    def _rclpy_tell_exception(self, error: Exception, where: str) -> None:
        self._rclpy_logger_of().error(f"{where}:\n{traceback.format_exc()}")

    def _rclpy_logger_of(self) -> Any:
        node: Any = self
        return node.get_logger()


class LifecycleNode(LifecycleNodeMixin, Node):
    """A node with managed states: unconfigured, inactive, active, finalized.

    >>> class Camera(LifecycleNode):
    ...     def on_configure(self, state):
    ...         print("opening the camera")
    ...         return super().on_configure(state)
    >>> camera = Camera("camera")
    >>> camera.trigger_configure().name
    opening the camera
    'SUCCESS'
    """

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)
