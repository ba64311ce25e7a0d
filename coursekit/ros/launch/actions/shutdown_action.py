"""Ends the launch."""

from __future__ import annotations

from typing import Any

from ..event import Event
from ..events import Shutdown as ShutdownEvent
from ..events.process import ProcessExited
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..logging import get_logger
from .emit_event import EmitEvent


@expose_action("shutdown")
class Shutdown(EmitEvent):
    """Ends the launch and everything that it started."""

    def __init__(self, *, reason: str = "reason not given", **kwargs: Any) -> None:
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Shutdown], dict[str, Any]]:
        """Read `<shutdown reason=/>`."""
        _, kwargs = super().parse(entity, parser)
        reason = entity.get_attr("reason", optional=True)
        if reason is not None:
            kwargs["reason"] = parser.escape_characters(reason)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Emit the shutdown; if a process has just ended, log that it was required."""
        event: Event | None = context.get_locals_as_dict().get("event")
        if isinstance(event, ProcessExited):
            get_logger("launch").info(
                f"process[{event.process_name}] was required: shutting down launched system"
            )
        return super().execute(context)


ShutdownAction = Shutdown
