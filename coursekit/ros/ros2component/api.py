"""Containers, and the components that they load."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from composition_interfaces.srv import ListNodes, LoadNode, UnloadNode
from rcl_interfaces.msg import Parameter
from ros2cli.helpers import call_service
from ros2cli.node.strategy import NodeStrategy
from ros2node.api import NodeName, get_node_names, get_service_server_info
from ros2param.api import get_parameter_value

from coursekit.processes.components import registered

if TYPE_CHECKING:
    from argparse import Namespace

COMPONENTS_RESOURCE_TYPE = "rclcpp_components"
_SERVICES = {"load_node": LoadNode, "unload_node": UnloadNode, "list_nodes": ListNodes}


class ComponentInfo(NamedTuple):
    """A component's ID in its container, and its full node name."""

    uid: int
    name: str


def get_registered_component_types() -> list[tuple[str, list[str]]]:
    """(package, classes) of the components that packages list."""
    return [(package, list(types)) for package, types in registered().items()]


def get_package_component_types(*, package_name: str | None = None) -> list[str]:
    """The classes of the components that a package lists."""
    return list(registered().get(package_name or "", {}))


def find_container_node_names(*, node: Any, node_names: Iterable[NodeName]) -> list[NodeName]:
    """The nodes that are containers."""
    return [name for name in node_names if _is_container(node, name)]


def _is_container(node: Any, name: NodeName) -> bool:
    served = dict(get_service_server_info(node=node, remote_node_name=name.full_name, include_hidden=True))
    return all(
        f"composition_interfaces/srv/{kind.__name__}" in served.get(f"{name.full_name}/_container/{service}", ())
        for service, kind in _SERVICES.items()
    )


def get_container_names(*, node: Any) -> list[NodeName]:
    """The containers of the graph."""
    return find_container_node_names(node=node, node_names=get_node_names(node=node))


def _call(node: Any, container: str, service: str, request: Any) -> Any:
    absent = f"No '{service}' service found for '{container}' container"
    return call_service(node, _SERVICES[service], f"{container}/_container/{service}", request, absent)


def get_components_in_container(*, node: Any, remote_container_node_name: str) -> tuple[bool, Any]:
    """True and the components of a container, or False and the reason why they are not known."""
    try:
        answer = _call(node, remote_container_node_name, "list_nodes", ListNodes.Request())
    except RuntimeError as error:
        return False, str(error)
    return True, [ComponentInfo(*pair) for pair in zip(answer.unique_ids, answer.full_node_names, strict=True)]


def get_components_in_containers(*, node: Any, remote_containers_node_names: Iterable[str]) -> dict[str, tuple[bool, Any]]:
    """The results of get_components_in_container, by container."""
    names = list(remote_containers_node_names)
    return {name: get_components_in_container(node=node, remote_container_node_name=name) for name in names}


def _parameters(assignments: Iterable[str] | None) -> list[Parameter]:
    parts = [assignment.partition(":=") for assignment in assignments or ()]
    return [Parameter(name=name, value=get_parameter_value(string_value=value)) for name, _, value in parts]


def load_component_into_container(
    *,
    node: Any,
    remote_container_node_name: str,
    package_name: str,
    plugin_name: str,
    node_name: str | None = None,
    node_namespace: str | None = None,
    log_level: Any = None,
    remap_rules: list[str] | None = None,
    parameters: list[str] | None = None,
    extra_arguments: list[str] | None = None,
) -> tuple[int, str]:
    """Load a component. Return its ID and full node name. Raises RuntimeError if the container cannot load it."""
    request = LoadNode.Request(package_name=package_name, plugin_name=plugin_name)
    request.node_name, request.node_namespace = node_name or "", node_namespace or ""
    request.log_level, request.remap_rules = int(log_level or 0), list(remap_rules or [])
    request.parameters, request.extra_arguments = _parameters(parameters), _parameters(extra_arguments)
    answer = _call(node, remote_container_node_name, "load_node", request)
    if not answer.success:
        reason = answer.error_message
        raise RuntimeError(f"Failed to load component: {reason[:1].upper()}{reason[1:]}")
    return answer.unique_id, answer.full_node_name


def unload_component_from_container(
    *, node: Any, remote_container_node_name: str, component_uids: Iterable[int]
) -> Iterator[tuple[int, bool, str]]:
    """Unload components. Yield for each its ID, whether it was unloaded, and the error message."""
    for uid in component_uids:
        answer = _call(node, remote_container_node_name, "unload_node", UnloadNode.Request(unique_id=uid))
        yield uid, answer.success, answer.error_message


def container_node_name_completer(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    """Full names of containers, for argcomplete."""
    with NodeStrategy(parsed_args) as node:
        return [name.full_name for name in get_container_names(node=node)]


class ComponentTypeNameCompleter:
    """Component classes of the package on the command line, for argcomplete."""

    def __init__(self, *, package_name_key: str | None = None) -> None:
        self.package_name_key = package_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The classes."""
        return get_package_component_types(package_name=getattr(parsed_args, str(self.package_name_key)))
