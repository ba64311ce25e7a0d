"""Loads components into a container."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.action import Action
from launch.frontend import Entity, Parser, expose_action
from launch.launch_context import LaunchContext
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.logging import get_logger
from launch.some_substitutions_type import SomeSubstitutionsType, SomeSubstitutionsType_types_tuple
from launch.utilities import ensure_argument_type, normalize_to_list_of_substitutions, perform_substitutions

from ..descriptions import ComposableNode
from ..ros_adapters import get_ros_node
from ..utilities import add_node_name, get_node_name_count
from ..utilities.parse_composable_node import parse_composable_nodes
from ..utilities.service_call import call_service
from .composable_node_container import ComposableNodeContainer
from .load_request import get_composable_node_load_request


@expose_action("load_composable_node")
class LoadComposableNodes(Action):
    """Loads components into a running container, one after the other.

    The container is given by its action or by the full name of its node. The action waits for it. A component that
    cannot be loaded causes an error in the log, but does not end the launch.
    """

    def __init__(
        self,
        *,
        composable_node_descriptions: Iterable[ComposableNode],
        target_container: SomeSubstitutionsType | ComposableNodeContainer,
        **kwargs: Any,
    ) -> None:
        kinds = (*SomeSubstitutionsType_types_tuple, ComposableNodeContainer)
        ensure_argument_type(target_container, kinds, "target_container", "LoadComposableNodes")
        super().__init__(**kwargs)
        self.__composable_node_descriptions = list(composable_node_descriptions)
        self.__target_container: Any = target_container
        if not isinstance(target_container, ComposableNodeContainer):
            self.__target_container = normalize_to_list_of_substitutions(target_container)
        self.__container_name = ""
        self.__client: Any = None
        self.__logger = get_logger(__name__)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Read `<load_composable_node target=><composable_node .../></load_composable_node>`."""
        _, kwargs = super().parse(entity, parser)
        kwargs["target_container"] = parser.parse_substitution(entity.get_attr("target"))
        kwargs["composable_node_descriptions"] = parse_composable_nodes(entity, parser, optional=False)
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Create the requests now, while the scope's settings apply; send them in parallel to the launch."""
        from composition_interfaces.srv import LoadNode

        self.__container_name = self.__name_of_container(context)
        service = f"{self.__container_name}/_container/load_node"
        self.__client = get_ros_node(context).create_client(LoadNode, service)
        requested = [
            get_composable_node_load_request(description, context) for description in self.__composable_node_descriptions
        ]
        requests = [request for request in requested if request is not None]
        if requests:
            assert context.asyncio_loop is not None
            loading = context.asyncio_loop.run_in_executor(None, self.__load_all, requests, context)
            context.add_completion_future(loading)
        return None

    def __name_of_container(self, context: LaunchContext) -> str:
        if isinstance(self.__target_container, ComposableNodeContainer):
            return self.__target_container.node_name
        return perform_substitutions(context, self.__target_container)

    def __load_all(self, requests: list[Any], context: LaunchContext) -> None:
        for request in requests:
            answer = call_service(self.__client, request, context, self.__logger)
            if answer is None:
                return
            self.__report(request, answer, context)

    def __report(self, request: Any, answer: Any, context: LaunchContext) -> None:
        name = answer.full_node_name or request.node_name
        if not answer.success:
            self.__logger.error(
                f"Failed to load node '{name}' of type '{request.plugin_name}' in container "
                f"'{self.__container_name}': {answer.error_message}"
            )
            return
        add_node_name(context, name)
        count = get_node_name_count(context, name)
        if count > 1:
            get_logger(self.__container_name).warning(
                f"there are now at least {count} nodes with the name {name} created within this launch context"
            )
        self.__logger.info(f"Loaded node '{answer.full_node_name}' in container '{self.__container_name}'")
