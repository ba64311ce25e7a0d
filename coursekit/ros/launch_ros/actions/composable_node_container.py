"""A container of components."""

from __future__ import annotations

from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions

from ..descriptions import ComposableNode
from .components import nodes_for
from .node_frontend import parse_parameters, parse_remaps


@expose_action("node_container")
class ComposableNodeContainer(Action):
    """Starts the components of a container, each as a process of its own.

    Components are C++ libraries; those that exist as Python executables of the same package run, the
    others give an error that says which name was looked for.
    """

    def __init__(
        self,
        *,
        name: SomeSubstitutionsType,
        namespace: SomeSubstitutionsType | None = None,
        composable_node_descriptions: list[ComposableNode] | None = None,
        condition: Any = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(condition=condition)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__namespace = namespace
        self.__descriptions = list(composable_node_descriptions or [])
        self.__container_arguments = kwargs

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<node_container name= pkg= exec= namespace=><composable_node .../></node_container>`."""
        _, kwargs = super().parse(entity, parser)
        for attribute in ("name", "namespace", "pkg", "exec", "args", "output"):
            value = entity.get_attr(attribute, optional=attribute != "name")
            if value is not None:
                kwargs[attribute] = parser.parse_substitution(value)
        kwargs["composable_node_descriptions"] = parse_components(entity, parser)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Return the nodes of the components."""
        nodes = nodes_for(context, self.__descriptions)
        name = "".join(context.perform_substitution(sub) for sub in self.__name)
        get_logger("launch_ros.actions.composable_node_container").info(
            f"container '{name}': its {len(nodes)} component(s) run as processes of their own"
        )
        return [*nodes]


def parse_components(entity: Entity, parser: Parser) -> list[ComposableNode]:
    """Return the `<composable_node>` elements inside an element."""
    components = []
    for item in entity.get_attr("composable_node", data_type=list[Entity], optional=True) or []:
        kwargs: dict[str, Any] = {
            "package": parser.parse_substitution(item.get_attr("pkg")),
            "plugin": parser.parse_substitution(item.get_attr("plugin")),
            "remappings": parse_remaps(item, parser),
        }
        for attribute in ("name", "namespace"):
            value = item.get_attr(attribute, optional=True)
            if value is not None:
                kwargs[attribute] = parser.parse_substitution(value)
        parameters = item.get_attr("param", data_type=list[Entity], optional=True)
        if parameters:
            kwargs["parameters"] = parse_parameters(parameters, parser)
        item.get_attr("extra_arg", data_type=list[Entity], optional=True)
        item.assert_entity_completely_parsed()
        components.append(ComposableNode(**kwargs))
    return components
