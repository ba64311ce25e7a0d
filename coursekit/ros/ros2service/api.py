"""Services and their types."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy
from rclpy.expand_topic_name import expand_topic_name
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.validate_full_topic_name import validate_full_topic_name
from ros2cli.node.strategy import NodeStrategy
from rosidl_runtime_py import get_service_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_service

from coursekit.processes.session import current

if TYPE_CHECKING:
    from argparse import Namespace

POLL_SECONDS = 0.1


def get_service_names_and_types(*, node: Any, include_hidden_services: bool = False) -> list[Any]:
    """(name, types) of the services."""
    services = node.get_service_names_and_types()
    return [(name, types) for name, types in services if include_hidden_services or not topic_or_service_is_hidden(name)]


def get_service_names(*, node: Any, include_hidden_services: bool = False) -> list[str]:
    """Names of the services."""
    return [name for name, _ in get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)]


def get_service_class(node: Any, service: str, blocking: bool = False, include_hidden_services: bool = False) -> Any:
    """The class of a service; None when no node has it. With `blocking`, wait until a node has it.

    Raises:
        RuntimeError: for a service of several types, or a type that is not installed.
    """
    service_class = _class_of(node, service, include_hidden_services)
    if service_class is None:
        print(f"WARNING: service [{service}] does not appear to be served yet")
    while service_class is None and blocking and rclpy.ok():
        current().clock.sleep(POLL_SECONDS)
        service_class = _class_of(node, service, include_hidden_services)
    return service_class


def _class_of(node: Any, service: str, include_hidden_services: bool) -> Any:
    name = expand_topic_name(service, node.get_name(), node.get_namespace())
    validate_full_topic_name(name, is_service=True)
    types = dict(get_service_names_and_types(node=node, include_hidden_services=include_hidden_services)).get(name)
    if not types:
        return None
    if len(types) > 1:
        raise RuntimeError(f"Cannot call service '{service}', as it contains more than one type: [{', '.join(types)}]")
    try:
        return get_service(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The service type '{types[0]}' is invalid") from None


def service_type_completer(**_: Any) -> list[str]:
    """All service types, for argcomplete."""
    return [f"{package}/{name}" for package, names in sorted(get_service_interfaces().items()) for name in sorted(names)]


class ServiceNameCompleter:
    """Names of services, for argcomplete."""

    def __init__(self, *, include_hidden_services_key: str | None = None) -> None:
        self.include_hidden_services_key = include_hidden_services_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The names of the existing services."""
        key = self.include_hidden_services_key
        hidden = bool(key and getattr(parsed_args, key))
        with NodeStrategy(parsed_args) as node:
            return get_service_names(node=node, include_hidden_services=hidden)


class ServiceTypeCompleter:
    """The type of the service on the command line, else all types, for argcomplete."""

    def __init__(self, *, service_name_key: str | None = None) -> None:
        self.service_name_key = service_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The types."""
        if self.service_name_key is not None:
            with NodeStrategy(parsed_args) as node:
                known = dict(get_service_names_and_types(node=node, include_hidden_services=True))
            types = known.get(getattr(parsed_args, self.service_name_key))
            if types:
                return list(types)
        return service_type_completer()


class ServicePrototypeCompleter:
    """The default request of the type on the command line, for argcomplete."""

    def __init__(self, *, service_type_key: str | None = None) -> None:
        self.service_type_key = service_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The values as YAML."""
        return [message_to_yaml(get_service(getattr(parsed_args, str(self.service_type_key))).Request())]
