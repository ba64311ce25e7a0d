"""The event that a lifecycle node has changed its state."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.event import Event

from .change_state import ChangeState

if TYPE_CHECKING:
    from ...actions.lifecycle_node import LifecycleNode


class StateTransition(Event):
    """A lifecycle node has reported a transition."""

    name = "launch_ros.events.lifecycle.StateTransition"

    def __init__(self, *, action: LifecycleNode, msg: Any) -> None:
        self.__action = action
        self.__msg = msg

    @property
    def action(self) -> LifecycleNode:
        """The node's action."""
        return self.__action

    @property
    def msg(self) -> Any:
        """The lifecycle_msgs/msg/TransitionEvent."""
        return self.__msg

    @property
    def timestamp(self) -> int:
        """The time of the transition in nanoseconds."""
        return int(self.__msg.timestamp)

    @property
    def transition(self) -> str:
        """The transition's label."""
        return str(self.__msg.transition.label)

    @property
    def start_state(self) -> str:
        """The state before the transition."""
        return ChangeState.valid_states[self.__msg.start_state.id]

    @property
    def goal_state(self) -> str:
        """The state after the transition."""
        return ChangeState.valid_states[self.__msg.goal_state.id]
