"""`ros2 run rclcpp_components component_container`: loads, lists and unloads components when asked."""

from __future__ import annotations

from typing import Any

import rclpy
from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rclpy.node import Node

from coursekit.core.components import find_component
from coursekit.nodes.running import spin_to_the_end

from .loading import LoadedComponent


class ComponentManager(Node):
    """The container's node: the services load_node, unload_node and list_nodes under ~/_container."""

    def __init__(self) -> None:
        super().__init__("ComponentManager")
        self._loaded: dict[int, LoadedComponent] = {}
        self._last_id = 0
        self._services_of_mine = [
            self.create_service(LoadNode, "~/_container/load_node", self._load),
            self.create_service(UnloadNode, "~/_container/unload_node", self._unload),
            self.create_service(ListNodes, "~/_container/list_nodes", self._list),
        ]

    def _load(self, request: LoadNode.Request, response: LoadNode.Response) -> LoadNode.Response:
        try:
            path = find_component(request.package_name, request.plugin_name)
            self.get_logger().info(f"Load Library: {path}")
            self.get_logger().info(f"Instantiate class: {request.plugin_name}")
            component = LoadedComponent(path, request, self._graph_of_mine())
        except (LookupError, RuntimeError, ValueError) as error:
            self.get_logger().error(str(error))
            response.error_message = str(error)
            return response
        self._last_id += 1
        self._loaded[self._last_id] = component
        response.success = True
        response.full_node_name = component.full_name
        response.unique_id = self._last_id
        return response

    def _graph_of_mine(self) -> Any:
        from coursekit.core.session import current

        return current().graph(self.context.get_domain_id())

    def _unload(self, request: UnloadNode.Request, response: UnloadNode.Response) -> UnloadNode.Response:
        component = self._loaded.pop(request.unique_id, None)
        if component is None:
            response.error_message = f"No node found with unique_id: {request.unique_id}"
            self.get_logger().warning(response.error_message)
            return response
        component.unload()
        response.success = True
        return response

    def _list(self, _: ListNodes.Request, response: ListNodes.Response) -> ListNodes.Response:
        response.unique_ids = list(self._loaded)
        response.full_node_names = [component.full_name for component in self._loaded.values()]
        return response

    def destroy_node(self) -> None:
        """Unload all, and leave the graph."""
        while self._loaded:
            self._loaded.popitem()[1].unload()
        super().destroy_node()


def main(args: list[str] | None = None) -> int:
    """Serve until Ctrl-C."""
    rclpy.init(args=args)
    return spin_to_the_end(ComponentManager())
