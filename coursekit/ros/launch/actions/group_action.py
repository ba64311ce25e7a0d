"""A group of actions with its own scope."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from ..action import Action
from ..frontend import Entity, Parser, expose_action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..some_substitutions_type import SomeSubstitutionsType
from .pop_environment import PopEnvironment
from .pop_launch_configurations import PopLaunchConfigurations
from .push_environment import PushEnvironment
from .push_launch_configurations import PushLaunchConfigurations
from .reset_environment import ResetEnvironment
from .reset_launch_configurations import ResetLaunchConfigurations
from .set_launch_configuration import SetLaunchConfiguration


@expose_action("group")
class GroupAction(Action):
    """Actions under one condition; their settings end with the group unless `scoped` is False.

    With `forwarding=False` the group does not inherit the configurations and the changed environment from
    outside; it has only its own `launch_configurations`.
    """

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[Any, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__actions = actions
        self.__scoped = scoped
        self.__forwarding = forwarding
        self.__configurations = dict(launch_configurations or {})
        self.__all: list[LaunchDescriptionEntity] | None = None

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<group scoped= forwarding=>` with `<keep name= value=/>` and actions."""
        _, kwargs = super().parse(entity, parser)
        for name in ("scoped", "forwarding"):
            value = entity.get_attr(name, data_type=bool, optional=True, can_be_str=False)
            if value is not None:
                kwargs[name] = value
        keeps = entity.get_attr("keep", data_type=list[Entity], optional=True)
        keeps = keeps or [child for child in entity.children if child.type_name == "keep"]
        if keeps:
            kwargs["launch_configurations"] = {
                tuple(parser.parse_substitution(keep.get_attr("name"))): parser.parse_substitution(
                    keep.get_attr("value")
                )
                for keep in keeps
            }
        kwargs["actions"] = [
            parser.parse_action(child) for child in entity.children if child.type_name != "keep"
        ]
        return cls, kwargs

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions, enclosed by the actions that open and close the scope."""
        if self.__all is None:
            self.__all = self.__with_scope(list(self.__actions))
        return self.__all

    def __with_scope(self, actions: list[LaunchDescriptionEntity]) -> list[LaunchDescriptionEntity]:
        settings = [SetLaunchConfiguration(name, value) for name, value in self.__configurations.items()]
        if not self.__scoped:
            return [*settings, *actions]
        opening: list[LaunchDescriptionEntity] = [PushLaunchConfigurations(), PushEnvironment()]
        if self.__forwarding:
            opening += settings
        else:
            opening += [ResetEnvironment(), ResetLaunchConfigurations(self.__configurations)]
        return [*opening, *actions, PopEnvironment(), PopLaunchConfigurations()]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the actions."""
        return self.get_sub_entities()
