"""Sets a launch configuration."""

from __future__ import annotations

from ..frontend import expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities import perform_substitutions
from .named import NamedValueAction


@expose_action("let")
class SetLaunchConfiguration(NamedValueAction):
    """Sets a launch configuration: `<let name= value=/>`.

    >>> from launch import LaunchContext
    >>> context = LaunchContext()
    >>> SetLaunchConfiguration("robot", "burger").execute(context)
    >>> context.launch_configurations["robot"]
    'burger'
    """

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Set the configuration."""
        name = perform_substitutions(context, self.name)
        context.launch_configurations[name] = perform_substitutions(context, self.value)
        return None
