"""`ros2 node list|info`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ros2node.api import INFO_NONUNIQUE_WARNING_TEMPLATE

from coursekit.cli import api
from coursekit.core.graph import names_and_types
from coursekit.core.graph_node import GraphNode
from coursekit.rcl.names import is_hidden

if TYPE_CHECKING:
    from argparse import Namespace

DUPLICATES = (
    "WARNING: Be aware that are nodes in the graph that share an exact name, this can have unintended side effects."
)


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("node", help="Various node related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    lister = verbs.add_parser("list", help="Output a list of available nodes")
    lister.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    lister.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes")
    lister.set_defaults(main=list_nodes)
    info = verbs.add_parser("info", help="Output information about a node")
    info.add_argument("node_name", help="Fully qualified node name").completer = api.complete_nodes
    info.add_argument("--include-hidden", action="store_true", help="Display hidden topics, services, and actions")
    info.set_defaults(main=show_info)


def list_nodes(args: Namespace) -> int:
    """Print the nodes' full names."""
    names = api.node_names(args.all)
    if args.count_nodes:
        print(len(names))
        return 0
    if len(set(names)) < len(names):
        api.say_error(DUPLICATES)
    for name in names:
        print(name)
    return 0


def show_info(args: Namespace) -> int:
    """Print the publishers, subscriptions, servers and clients of a node."""
    name = api.full_name(args.node_name)
    count = api.node_names(args.include_hidden).count(name)
    if not count:
        print(f"Unable to find node '{args.node_name}'")
        return 1
    if count > 1:
        api.say_error(INFO_NONUNIQUE_WARNING_TEMPLATE.format(num_nodes=count, node_name=name))
    node = api.find_node(name)
    print(name)
    for title, endpoints in (
        ("Subscribers", node.subscriptions),
        ("Publishers", node.publishers),
        ("Service Servers", node.servers),
        ("Service Clients", node.clients),
    ):
        pairs = names_and_types(endpoints)
        _section(title, [pair for pair in pairs if args.include_hidden or not is_hidden(pair[0])])
    _actions(node, args.include_hidden)
    return 0


def _section(title: str, pairs: list[tuple[str, list[str]]]) -> None:
    print(f"  {title}:")
    print("\n".join(f"    {name}: {', '.join(types)}" for name, types in pairs))


def _actions(node: GraphNode, hidden: bool) -> None:
    from rclpy.action import graph as action_graph

    with api.command_node() as asking:
        for title, find in (
            ("Action Servers", action_graph.get_action_server_names_and_types_by_node),
            ("Action Clients", action_graph.get_action_client_names_and_types_by_node),
        ):
            pairs = find(asking, node.name, node.namespace)
            _section(title, [pair for pair in pairs if hidden or not is_hidden(pair[0])])
