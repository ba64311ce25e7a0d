"""Unsets a launch configuration."""

from __future__ import annotations

from ..frontend import expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import perform_substitutions
from .named import NamedAction


@expose_action("unset")
class UnsetLaunchConfiguration(NamedAction):
    """Removes a launch configuration, `<unset name=/>`; no effect if it is not set."""

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Unset the configuration."""
        context.launch_configurations.pop(perform_substitutions(context, self.name), None)
        return None
