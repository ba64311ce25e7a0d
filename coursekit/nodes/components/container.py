"""`ros2 run rclcpp_components component_container`: loads, lists and unloads components on request."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rclpy.node import Node

from coursekit.nodes.running import run
from coursekit.processes.components import find_component, library_of, share_told_signals
from coursekit.processes.process import current_process
from coursekit.systems import signal_names

from .loading import LoadedComponent, given_by


class ComponentManager(Node):
    """The container's node: the services load_node, unload_node and list_nodes under ~/_container."""

    def __init__(self) -> None:
        super().__init__("ComponentManager")
        self._loaded: dict[int, LoadedComponent] = {}
        self._last_id = 0
        self._libraries: set[Path] = set()
        self._process = current_process()
        if self._process is not None:
            self._process.cleanups.append(self._kill_all)
        self._services_of_mine = [
            self.create_service(LoadNode, "~/_container/load_node", self._load),
            self.create_service(UnloadNode, "~/_container/unload_node", self._unload),
            self.create_service(ListNodes, "~/_container/list_nodes", self._list),
        ]

    def _load(self, request: LoadNode.Request, response: LoadNode.Response) -> LoadNode.Response:
        try:
            words = [] if self._process is None else self._process.argv[1:]
            path = self._library(request)
            component = LoadedComponent(path, given_by(request), self._graph_of_mine(), words, request.log_level)
        except (LookupError, RuntimeError, ValueError) as error:
            self.get_logger().error(str(error))
            response.error_message = str(error)
            return response
        self._last_id += 1
        number = self._last_id
        self._loaded[number] = component
        component.process.on_exit(lambda _: self._ended(number))
        response.success = True
        response.full_node_name = component.full_name
        response.unique_id = number
        return response

    def _library(self, request: LoadNode.Request) -> Path:
        path = find_component(request.package_name, request.plugin_name)
        library = library_of(path, request.package_name, request.plugin_name)
        if library not in self._libraries:
            self._libraries.add(library)
            self.get_logger().info(f"Load Library: {library}")
        for what in ("Found", "Instantiate"):
            self.get_logger().info(f"{what} class: rclcpp_components::NodeFactoryTemplate<{request.plugin_name}>")
        return path

    def _graph_of_mine(self) -> Any:
        from coursekit.processes.session import current

        return current().graph(self.context.get_domain_id())

    def _ended(self, number: int) -> None:
        """Handle a component that ended by itself; a crashed one aborts the container, as in ROS 2."""
        component = self._loaded.pop(number, None)
        if component is not None and component.process.exit_code and self._process is not None:
            self._process.send_signal(signal_names.ABORT)

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

    def _take_all(self) -> list[LoadedComponent]:
        components, self._loaded = list(self._loaded.values()), {}
        return components

    def _kill_all(self) -> None:
        for component in self._take_all():
            component.process.kill()

    def destroy_node(self) -> None:
        """Unload all, and leave the graph."""
        components, told = self._take_all(), set[int]()
        for component in components:
            share_told_signals(component.process, told)
            component.process.interrupt()
        for component in components:
            component.process.wait(2.0)
        super().destroy_node()


def main(args: list[str] | None = None) -> int:
    """Run the container until Ctrl-C."""
    return run(ComponentManager, args)
