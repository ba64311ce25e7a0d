"""Unsets an environment variable."""

from __future__ import annotations

from ..frontend import expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import perform_substitutions
from .named import NamedAction


@expose_action("unset_env")
class UnsetEnvironmentVariable(NamedAction):
    """Removes an environment variable, `<unset_env name=/>`; no effect if it is not set."""

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Unset the variable."""
        name = perform_substitutions(context, self.name)
        if name in context.environment:
            del context.environment[name]
        return None
