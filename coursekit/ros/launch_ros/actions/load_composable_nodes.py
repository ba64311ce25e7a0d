"""Loads components into a container."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity

from ..descriptions import ComposableNode
from .components import nodes_for
from .composable_node_container import parse_components


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Starts components, each as a process of its own; see ComposableNodeContainer."""

    def __init__(
        self,
        *,
        composable_node_descriptions: list[ComposableNode],
        target_container: Any,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__descriptions = list(composable_node_descriptions)
        self.__target_container = target_container

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<load_composable_node target=><composable_node .../></load_composable_node>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        kwargs["composable_node_descriptions"] = parse_components(entity, parser)
        return cls, kwargs

    @property
    def target_container(self) -> Any:
        """The container they are meant for."""
        return self.__target_container

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the nodes of the components."""
        return [*nodes_for(context, self.__descriptions)]
