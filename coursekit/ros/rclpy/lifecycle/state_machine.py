"""The states of a managed node and the transitions between them, with ROS's ids and labels."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import Any, NamedTuple

from rclpy._rclpy_pybind11 import RCLError
from rclpy.logging import get_logger

NOT_REGISTERED = "Transition is not registered., at ./src/rcl_lifecycle.c:355"
_TRIGGER = f"Failed to trigger lifecycle state machine transition: {NOT_REGISTERED}"
_LABEL = "Failed to get transition from label: error not set"


class TransitionCallbackReturnType(IntEnum):
    """The result of a transition callback."""

    SUCCESS = 97
    FAILURE = 98
    ERROR = 99

    def __str__(self) -> str:
        return f"{type(self).__name__}.{self.name}"

    def to_label(self) -> str:
        """The label of the transition that follows this result."""
        return f"transition_{self.name.lower()}"


class LifecycleState(NamedTuple):
    """A state as passed to callbacks."""

    label: str
    state_id: int


class Transition(NamedTuple):
    """A transition from one state to another."""

    transition_id: int
    label: str
    start: int
    goal: int


STATES = {
    0: "unknown",
    1: "unconfigured",
    2: "inactive",
    3: "active",
    4: "finalized",
    10: "configuring",
    11: "cleaningup",
    12: "shuttingdown",
    13: "activating",
    14: "deactivating",
    15: "errorprocessing",
}


def _asked(number: int, label: str, start: int, through: int, success: int, failure: int) -> list[Transition]:
    """A requested transition, and the three transitions that may follow its callback."""
    return [Transition(number, label, start, through), *_ends(number * 10, through, success, failure)]


def _ends(first_id: int, through: int, success: int, failure: int, error: int = 15) -> list[Transition]:
    return [
        Transition(first_id, "transition_success", through, success),
        Transition(first_id + 1, "transition_failure", through, failure),
        Transition(first_id + 2, "transition_error", through, error),
    ]


TRANSITIONS: list[Transition] = [
    *_asked(1, "configure", start=1, through=10, success=2, failure=1),
    *_asked(2, "cleanup", start=2, through=11, success=1, failure=2),
    *_asked(3, "activate", start=2, through=13, success=3, failure=2),
    *_asked(4, "deactivate", start=3, through=14, success=2, failure=3),
    Transition(5, "shutdown", 1, 12),
    Transition(6, "shutdown", 2, 12),
    Transition(7, "shutdown", 3, 12),
    *_ends(50, through=12, success=4, failure=4),
    *_ends(60, through=15, success=1, failure=4, error=4),
]


class StateMachine:
    """A node's state. `notify(start, goal)` is called on every change, unless `publish_update` is False.

    >>> machine = StateMachine()
    >>> machine.trigger_transition_by_label("configure")
    >>> machine.current_state
    (10, 'configuring')
    """

    service_change_state: Any = None
    service_get_state: Any = None
    service_get_available_states: Any = None
    service_get_available_transitions: Any = None
    service_get_transition_graph: Any = None

    def __init__(self, notify: Callable[[int, int], None] = lambda start, goal: None) -> None:
        self._state = 1
        self._notify = notify

    @property
    def initialized(self) -> bool:
        """Whether the state machine is initialized: always, here."""
        return True

    @property
    def current_state(self) -> tuple[int, str]:
        """The id and the label of the current state."""
        return self._state, STATES[self._state]

    @property
    def available_states(self) -> list[tuple[int, str]]:
        """The ids and labels of all states."""
        return list(STATES.items())

    @property
    def available_transitions(self) -> list[Transition]:
        """The transitions out of the current state."""
        return [each for each in TRANSITIONS if each.start == self._state]

    @property
    def transition_graph(self) -> list[Transition]:
        """All transitions."""
        return list(TRANSITIONS)

    def get_transition_by_label(self, label: str) -> int:
        """Return the id of the current state's transition with that label; RCLError if there is none."""
        return self._find(label, lambda each: each.label == label, _LABEL).transition_id

    def trigger_transition_by_id(self, transition_id: int, publish_update: bool = True) -> None:
        """Make the transition; RCLError if the current state has no such transition."""
        self._go(self._find(transition_id, lambda each: each.transition_id == transition_id), publish_update)

    def trigger_transition_by_label(self, label: str, publish_update: bool = True) -> None:
        """Make the transition; RCLError if the current state has no such transition."""
        self._go(self._find(label, lambda each: each.label == label), publish_update)

    def _find(self, wanted: object, fits: Callable[[Transition], bool], failure: str = _TRIGGER) -> Transition:
        for each in self.available_transitions:
            if fits(each):
                return each
        get_logger("rcl_lifecycle").warning(f"No transition matching {wanted} found for current state {STATES[self._state]}")
        known = ", ".join(f"{each.label} [{each.transition_id}]" for each in self.available_transitions)
        raise RCLError(f"{failure} (known: {known or 'none'})")

    def _go(self, transition: Transition, publish_update: bool) -> None:
        self._state = transition.goal
        if publish_update:
            self._notify(transition.start, transition.goal)
