"""Takes lifecycle nodes through several transitions."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import zip_longest
from typing import Any

from launch.action import Action
from launch.actions import EmitEvent, RegisterEventHandler
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from ..event_handlers import OnStateTransition
from ..events import matches_node_name
from ..events.lifecycle import ChangeState, StateTransition

GOALS = {
    "TRANSITION_CONFIGURE": "inactive",
    "TRANSITION_CLEANUP": "unconfigured",
    "TRANSITION_ACTIVATE": "active",
    "TRANSITION_DEACTIVATE": "inactive",
}


class LifecycleTransition(Action):
    """Makes each named node perform the transitions, one after the other."""

    def __init__(
        self,
        *,
        lifecycle_node_names: Iterable[SomeSubstitutionsType],
        transition_ids: Iterable[int | str],
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__names = [normalize_to_list_of_substitutions(name) for name in lifecycle_node_names]
        self.__transitions = [int(transition) for transition in transition_ids]
        if not self.__names or not self.__transitions:
            raise ValueError("LifecycleTransition needs at least one node name and one transition")

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the first transition, and the event handlers that start the next one after each."""
        entities: list[LaunchDescriptionEntity] = []
        for name in self.__names:
            entities += self.__of_node(perform_substitutions(context, name))
        return entities

    def __of_node(self, node_name: str) -> list[LaunchDescriptionEntity]:
        matcher = matches_node_name(node_name)
        steps = [
            EmitEvent(event=ChangeState(lifecycle_node_matcher=matcher, transition_id=transition))
            for transition in self.__transitions
        ]
        handlers: list[LaunchDescriptionEntity] = []
        for transition, following in zip_longest(self.__transitions, steps[1:]):
            goal = GOALS.get(ChangeState.valid_transitions[transition], "finalized")
            handlers.append(
                RegisterEventHandler(
                    OnStateTransition(
                        matcher=lambda event, goal=goal: (
                            isinstance(event, StateTransition)  # type: ignore[misc]
                            and matcher(event.action)
                            and event.goal_state == goal
                        ),
                        entities=[] if following is None else [following],
                        handle_once=True,
                    )
                )
            )
        return [*handlers, steps[0]]
