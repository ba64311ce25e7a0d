"""The base class of all actions."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .condition import Condition
from .launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from .frontend import Entity, Parser
    from .launch_context import LaunchContext


class Action(LaunchDescriptionEntity):
    """A step of a launch file, optionally under a condition."""

    def __init__(self, *, condition: Condition | None = None) -> None:
        self.__condition = condition

    @staticmethod
    def parse(entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the constructor arguments for an XML or YAML element.

        Raises:
            RuntimeError: if both `if` and `unless` are given.
        """
        from .conditions import IfCondition, UnlessCondition

        if_text = entity.get_attr("if", optional=True)
        unless_text = entity.get_attr("unless", optional=True)
        if if_text is not None and unless_text is not None:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        if if_text is not None:
            return Action, {"condition": IfCondition(parser.parse_substitution(if_text))}
        if unless_text is not None:
            return Action, {"condition": UnlessCondition(parser.parse_substitution(unless_text))}
        return Action, {}

    @property
    def condition(self) -> Condition | None:
        """The condition that decides whether the action is executed."""
        return self.__condition

    def describe(self) -> str:
        """Return a short description of this action."""
        return f"{type(self).__name__}()"

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities that this action returns when it is executed."""
        return []

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the sub-entities, if this action has no condition."""
        return self.get_sub_entities() if self.condition is None else []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the sub-entities that depend on this action's condition."""
        if self.condition is None:
            return []
        return [("Conditionally included by " + self.describe(), self.get_sub_entities())]

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Execute the action if its condition is true."""
        if self.__condition is not None and not self.__condition.evaluate(context):
            return None
        try:
            return self.execute(context)
        finally:
            from .events import ExecutionComplete

            event = ExecutionComplete(action=self)
            if context.would_handle_event(event):
                self.__announce_completion(context, event)

    def __announce_completion(self, context: LaunchContext, event: Any) -> None:
        future = self.get_asyncio_future()
        if future is None:
            context.emit_event_sync(event)
        else:
            future.add_done_callback(lambda _: context.emit_event_sync(event))

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do the action's work; subclasses override this."""
        return None
