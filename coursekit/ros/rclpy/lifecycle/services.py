"""The interface for other nodes to see and change a node's state: five services and a topic."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from lifecycle_msgs.msg import State, Transition, TransitionDescription, TransitionEvent
from lifecycle_msgs.srv import ChangeState, GetAvailableStates, GetAvailableTransitions, GetState

from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle import state_machine
from rclpy.lifecycle.state_machine import STATES, StateMachine
from rclpy.lifecycle.state_machine import TransitionCallbackReturnType as TransitionCallbackReturn

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.node import Node

ChangeById = Callable[[int], TransitionCallbackReturn]


def event_of(start: int, goal: int) -> TransitionEvent:
    """Return the message about a state change (like rcl's, it contains only the states)."""
    return TransitionEvent(start_state=_state(start), goal_state=_state(goal))


def _state(state_id: int) -> State:
    return State(id=state_id, label=STATES[state_id])


def _description(each: state_machine.Transition) -> TransitionDescription:
    transition = Transition(id=each.transition_id, label=each.label)
    return TransitionDescription(
        transition=transition, start_state=_state(each.start), goal_state=_state(each.goal)
    )


class LifecycleServices:
    """The services of one node; they act on its state machine through `change`."""

    def __init__(self, node: Node, machine: StateMachine, change: ChangeById, callback_group: CallbackGroup) -> None:
        self._machine = machine
        self._change = change
        offers: list[tuple[type[Any], str, Callable[[Any, Any], Any]]] = [
            (ChangeState, "~/change_state", self._change_state),
            (GetState, "~/get_state", self._get_state),
            (GetAvailableStates, "~/get_available_states", self._available_states),
            (GetAvailableTransitions, "~/get_available_transitions", self._available_transitions),
            (GetAvailableTransitions, "~/get_transition_graph", self._transition_graph),
        ]
        for type_, name, callback in offers:
            service = node.create_service(type_, name, callback, callback_group=callback_group)
            word = name.replace("~/", "service_")
            setattr(node, f"_{word}", service)
            setattr(machine, word, service.handle)

    def _change_state(self, request: ChangeState.Request, response: ChangeState.Response) -> ChangeState.Response:
        """Make the requested transition: the label selects it if there is one, otherwise the id."""
        wanted = request.transition
        try:
            if wanted.label:
                wanted.id = self._machine.get_transition_by_label(wanted.label)
            response.success = self._change(wanted.id) == TransitionCallbackReturn.SUCCESS
        except RCLError:
            response.success = False
        return response

    def _get_state(self, request: GetState.Request, response: GetState.Response) -> GetState.Response:
        response.current_state = _state(self._machine.current_state[0])
        return response

    def _available_states(
        self, request: GetAvailableStates.Request, response: GetAvailableStates.Response
    ) -> GetAvailableStates.Response:
        response.available_states = [_state(state_id) for state_id in STATES]
        return response

    def _available_transitions(
        self, request: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response
    ) -> GetAvailableTransitions.Response:
        response.available_transitions = [_description(each) for each in self._machine.available_transitions]
        return response

    def _transition_graph(
        self, request: GetAvailableTransitions.Request, response: GetAvailableTransitions.Response
    ) -> GetAvailableTransitions.Response:
        response.available_transitions = [_description(each) for each in self._machine.transition_graph]
        return response
