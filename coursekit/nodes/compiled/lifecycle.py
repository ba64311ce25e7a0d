"""A compiled program's managed nodes: rclpy's state machine and services with the program's callbacks."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle import LifecycleNodeMixin, LifecycleState, TransitionCallbackReturn
from rclpy.lifecycle.state_machine import NOT_REGISTERED, STATES, Transition

from coursekit.nodes.compiled.frames import Unpacker, packed
from coursekit.nodes.compiled.node import CompiledNode

if TYPE_CHECKING:
    from coursekit.nodes.compiled.channel import Channel
    from coursekit.nodes.compiled.host import Host

_BY_ID = 1


class CompiledLifecycleNode(LifecycleNodeMixin, CompiledNode):
    """Its transitions call the program's functions; error messages are rclcpp's."""

    declares_events_qos = False

    def __init__(self, node_name: str, **options: Any) -> None:
        CompiledNode.__init__(self, node_name, **options)

    def begin(self, host: Host, handler: int, communicates: bool) -> None:
        """Become a managed node; `handler` is called for each transition."""
        self._host, self._handler = host, handler
        LifecycleNodeMixin.__init__(self, enable_communication_interface=communicates)

    def _rclpy_call_back(self, before: LifecycleState) -> TransitionCallbackReturn:
        through = self._state_machine.current_state[0]
        told = packed(through, before.state_id)
        answer = TransitionCallbackReturn(self._host.call(self._handler, told).integer())
        self._state_machine.trigger_transition_by_label(answer.to_label())
        if answer == TransitionCallbackReturn.ERROR and through != _ERROR_PROCESSING:
            self.get_logger().warning("Error occurred while doing error handling.")
        return answer

    def _rclpy_change_if_possible(self, transition_id: int) -> TransitionCallbackReturn:
        try:
            return self._rclpy_change_state(transition_id)
        except RCLError:
            state = self._state_machine.current_state[1]
            text = f"Unable to start transition {transition_id} from current state {state}: {NOT_REGISTERED}"
            self.get_logger().error(text)
            return TransitionCallbackReturn.ERROR

    def change(self, transition_id: int) -> int:
        """Perform a transition; 97 for success, 98 for failure, 99 for an error."""
        return int(self._rclpy_change_if_possible(transition_id))

    def change_by_name(self, label: str) -> int:
        """Perform a transition like `change`; 0 if the state has none of that name."""
        try:
            return self.change(self._state_machine.get_transition_by_label(label))
        except RCLError:
            return 0

    def transitions(self, all_of_them: bool) -> list[Transition]:
        """Return the transitions from the current state, or all."""
        return self._state_machine.transition_graph if all_of_them else self._state_machine.available_transitions


_ERROR_PROCESSING = 15


def do_lifecycle(host: Host, _channel: Channel, frame: Unpacker) -> None:
    """Make a node managed: with callbacks, and with or without services."""
    node: CompiledLifecycleNode = host.things[frame.integer()]
    node.begin(host, frame.integer(), bool(frame.integer()))


def do_lifecycle_state(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """The number of a node's state."""
    return packed(host.things[frame.integer()]._state_machine.current_state[0])


def do_lifecycle_change(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Perform a transition, by number or name. Returns the callback's result."""
    node, how = host.things[frame.integer()], frame.integer()
    return packed(node.change(frame.integer()) if how == _BY_ID else node.change_by_name(frame.text()))


def do_lifecycle_states(_host: Host, _channel: Channel, _frame: Unpacker) -> bytes:
    """All states."""
    return packed(len(STATES), *(word for item in STATES.items() for word in item))


def do_lifecycle_transitions(host: Host, _channel: Channel, frame: Unpacker) -> bytes:
    """Return the transitions that a node can perform now, or all."""
    transitions = host.things[frame.integer()].transitions(bool(frame.integer()))
    words = [
        word
        for transition in transitions
        for word in (transition.transition_id, transition.label, transition.start, transition.goal)
    ]
    return packed(len(transitions), *words)
