"""Opens a scope of launch configurations."""

from __future__ import annotations

from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity


@expose_action("push_launch_configurations")
class PushLaunchConfigurations(Action):
    """Saves the launch configurations until they are popped."""

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<push_launch_configurations/>`."""
        _, kwargs = super().parse(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Save the configurations."""
        context._push_launch_configurations()
        return None
