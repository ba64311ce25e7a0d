"""Actions, their servers and their clients."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import rclpy.action
from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name
from ros2cli.node.strategy import NodeStrategy
from ros2node.api import get_action_client_info, get_action_server_info, get_node_names
from rosidl_runtime_py import get_action_interfaces, message_to_yaml
from rosidl_runtime_py.utilities import get_action

if TYPE_CHECKING:
    from argparse import Namespace

NamesAndTypes = list[tuple[str, list[str]]]


def get_action_names_and_types(*, node: Any) -> NamesAndTypes:
    """(name, types) of the actions."""
    return list(rclpy.action.get_action_names_and_types(getattr(node, "direct_node", node)))


def get_action_names(*, node: Any) -> list[str]:
    """Names of the actions."""
    return [name for name, _ in get_action_names_and_types(node=node)]


def get_action_clients_and_servers(*, node: Any, action_name: str) -> tuple[NamesAndTypes, NamesAndTypes]:
    """(full node name, types) of an action's clients, and of its servers."""
    name = expand_topic_name(action_name, node.get_name(), node.get_namespace())
    validate_full_topic_name(name)
    clients: NamesAndTypes = []
    servers: NamesAndTypes = []
    for other in get_node_names(node=node, include_hidden_nodes=True):
        for ends, ask in ((clients, get_action_client_info), (servers, get_action_server_info)):
            known = dict(ask(node=node, remote_node_name=other.full_name, include_hidden=True))
            if name in known:
                ends.append((other.full_name, known[name]))
    return clients, servers


def get_action_class(node: Any, action_name: str) -> Any:
    """The class of an action; None when no node has it.

    Raises:
        RuntimeError: for an action of several types, or a type that is not installed.
    """
    name = expand_topic_name(action_name, node.get_name(), node.get_namespace())
    types = dict(get_action_names_and_types(node=node)).get(name)
    if not types:
        return None
    if len(types) > 1:
        raise RuntimeError(f"Action '{action_name}' has more than one type: [{', '.join(types)}]")
    try:
        return get_action(types[0])
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise RuntimeError(f"The action type '{types[0]}' is invalid") from None


def action_name_completer(prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
    """Names of actions, for argcomplete."""
    with NodeStrategy(parsed_args) as node:
        return get_action_names(node=node)


def action_type_completer(**_: Any) -> list[str]:
    """All action types, for argcomplete."""
    return [f"{package}/{name}" for package, names in sorted(get_action_interfaces().items()) for name in sorted(names)]


class ActionTypeCompleter:
    """The type of the action on the command line, else all types, for argcomplete."""

    def __init__(self, *, action_name_key: str | None = None) -> None:
        self.action_name_key = action_name_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The types."""
        if self.action_name_key is None:
            return action_type_completer()
        with NodeStrategy(parsed_args) as node:
            known = dict(get_action_names_and_types(node=node))
        return list(known.get(getattr(parsed_args, self.action_name_key), []))


class ActionGoalPrototypeCompleter:
    """The default goal of the type on the command line, for argcomplete."""

    def __init__(self, *, action_type_key: str | None = None) -> None:
        self.action_type_key = action_type_key

    def __call__(self, prefix: str, parsed_args: Namespace, **_: Any) -> list[str]:
        """The values as YAML."""
        return [message_to_yaml(get_action(getattr(parsed_args, str(self.action_type_key))).Goal())]
