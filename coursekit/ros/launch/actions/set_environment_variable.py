"""Sets an environment variable."""

from __future__ import annotations

from ..frontend import expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import perform_substitutions
from .named import NamedValueAction


@expose_action("set_env")
class SetEnvironmentVariable(NamedValueAction):
    """Sets an environment variable for programs that are started afterwards: `<set_env name= value=/>`."""

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Set the variable."""
        name = perform_substitutions(context, self.name)
        context.environment[name] = perform_substitutions(context, self.value)
        return None
