"""A container of components."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType

from ..descriptions import ComposableNode
from ..utilities.parse_composable_node import parse_composable_nodes
from .node import Node


@expose_action("node_container")
class ComposableNodeContainer(Node):
    """Starts a container and loads components into it. It takes all arguments of Node.

    >>> from launch_ros.descriptions import ComposableNode
    >>> talker = ComposableNode(package="composition", plugin="composition::Talker", name="talker")
    >>> container = ComposableNodeContainer(
    ...     name="container",
    ...     namespace="",
    ...     package="rclcpp_components",
    ...     executable="component_container",
    ...     composable_node_descriptions=[talker],
    ... )
    >>> container.node_executable
    'component_container'
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType,
        composable_node_descriptions: Iterable[ComposableNode] | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__composable_node_descriptions = list(composable_node_descriptions or [])

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Node], dict[str, Any]]:  # type: ignore[override]
        """Read `<node_container name= namespace= pkg= exec=><composable_node .../></node_container>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["composable_node_descriptions"] = parse_composable_nodes(entity, parser, optional=True)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the container; return the entities that follow, such as the action that loads its components."""
        from .load_composable_nodes import LoadComposableNodes

        entities = list(super().execute(context) or [])
        if self.__composable_node_descriptions:
            entities.append(
                LoadComposableNodes(composable_node_descriptions=self.__composable_node_descriptions, target_container=self)
            )
        return entities
