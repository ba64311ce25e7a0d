"""The event that makes lifecycle nodes change their state."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from launch.event import Event
from lifecycle_msgs.msg import State, Transition

if TYPE_CHECKING:
    from ...actions.lifecycle_node import LifecycleNode


def _names(constants: type, prefix: tuple[str, ...]) -> dict[int, str]:
    """Return the constants of a message class by number, in lower case without the prefix."""
    names = {}
    for name in dir(constants):
        if name.startswith(prefix) and isinstance(getattr(constants, name), int):
            matching = next(start for start in prefix if name.startswith(start))
            names[getattr(constants, name)] = name.removeprefix(matching).lower()
    return names


class ChangeState(Event):
    """A request for a transition to all lifecycle nodes that `lifecycle_node_matcher` accepts."""

    name = "launch_ros.events.lifecycle.ChangeState"
    valid_states: ClassVar[dict[int, str]] = _names(State, ("PRIMARY_STATE_", "TRANSITION_STATE_"))
    valid_transitions: ClassVar[dict[int, str]] = {
        getattr(Transition, name): name
        for name in (
            "TRANSITION_CONFIGURE",
            "TRANSITION_CLEANUP",
            "TRANSITION_ACTIVATE",
            "TRANSITION_DEACTIVATE",
            "TRANSITION_UNCONFIGURED_SHUTDOWN",
            "TRANSITION_INACTIVE_SHUTDOWN",
            "TRANSITION_ACTIVE_SHUTDOWN",
        )
    }

    def __init__(
        self, *, lifecycle_node_matcher: Callable[[LifecycleNode], bool], transition_id: int
    ) -> None:
        if transition_id not in self.valid_transitions:
            raise ValueError(
                f"given an invalid transition_id '{transition_id}', expected one of: "
                f"{', '.join(f'{number} ({name})' for number, name in self.valid_transitions.items())}"
            )
        self.__matcher = lifecycle_node_matcher
        self.__transition_id = transition_id

    @property
    def lifecycle_node_matcher(self) -> Callable[[LifecycleNode], bool]:
        """A function that returns whether a node must make the transition."""
        return self.__matcher

    @property
    def transition_id(self) -> int:
        """The transition's number."""
        return self.__transition_id
