"""The description of a system to launch: a list of entities."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from .action import Action
from .launch_context import LaunchContext
from .launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from .actions import DeclareLaunchArgument, IncludeLaunchDescription


class LaunchDescription(LaunchDescriptionEntity):
    """The result of `generate_launch_description()`: entities that are visited in order."""

    def __init__(
        self,
        initial_entities: Iterable[LaunchDescriptionEntity] | None = None,
        *,
        deprecated_reason: str | None = None,
    ) -> None:
        self.__entities = list(initial_entities) if initial_entities is not None else []
        self.__deprecated_reason = deprecated_reason

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the entities; warn if the description is deprecated."""
        if self.__deprecated_reason is not None:
            from .logging import get_logger

            path = context.get_locals_as_dict().get("current_launch_file_path")
            what = f"launch file [{path}] is deprecated" if path else "deprecated launch description"
            get_logger().warning(f"{what}: {self.__deprecated_reason}")
        return self.__entities

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities."""
        return self.__entities

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[DeclareLaunchArgument]:
        """Return the arguments that this description and its includes declare, each name once."""
        pairs = self.get_launch_arguments_with_include_launch_description_actions(conditional_inclusion)
        return [argument for argument, _ in pairs]

    def get_launch_arguments_with_include_launch_description_actions(
        self, conditional_inclusion: bool = False
    ) -> list[tuple[DeclareLaunchArgument, list[IncludeLaunchDescription] | None]]:
        """Return each argument with the includes that lead to it, or None for arguments of this description."""
        search = _ArgumentSearch()
        search.look_in(self.entities, conditional_inclusion, None)
        return search.found

    @property
    def entities(self) -> list[LaunchDescriptionEntity]:
        """The entities."""
        return self.__entities

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        """Append an entity."""
        self.__entities.append(entity)

    def add_action(self, action: Action) -> None:
        """Append an action."""
        self.add_entity(action)

    @property
    def deprecated(self) -> bool:
        """Whether the description is deprecated."""
        return self.__deprecated_reason is not None

    @property
    def deprecated_reason(self) -> str | None:
        """The reason for the deprecation; None if the description is not deprecated."""
        return self.__deprecated_reason


class _ArgumentSearch:
    """Collects the declared arguments of a tree of entities."""

    def __init__(self) -> None:
        self.found: list[tuple[DeclareLaunchArgument, list[IncludeLaunchDescription] | None]] = []

    def look_in(
        self,
        entities: Iterable[LaunchDescriptionEntity],
        conditional: bool,
        includes: list[IncludeLaunchDescription] | None,
    ) -> None:
        """Search entities up to a ResetLaunchConfigurations: later arguments cannot be set from outside."""
        from .actions import DeclareLaunchArgument, IncludeLaunchDescription, ResetLaunchConfigurations

        for entity in entities:
            if isinstance(entity, ResetLaunchConfigurations):
                return
            if isinstance(entity, DeclareLaunchArgument):
                self.__keep(entity, conditional, includes)
            inner: Any = includes
            if isinstance(entity, IncludeLaunchDescription):
                inner = [*(includes or []), entity]
            self.look_in(entity.describe_sub_entities(), conditional, inner)
            for _, sub_entities in entity.describe_conditional_sub_entities():
                self.look_in(sub_entities, True, inner)

    def __keep(
        self,
        argument: DeclareLaunchArgument,
        conditional: bool,
        includes: list[IncludeLaunchDescription] | None,
    ) -> None:
        if argument.name in [known.name for known, _ in self.found]:
            return
        argument._conditionally_included = conditional or argument.condition is not None
        self.found.append((argument, includes))
