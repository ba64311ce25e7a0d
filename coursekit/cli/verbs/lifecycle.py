"""`ros2 lifecycle nodes|get|list|set`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli import api

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.node import Node

_GET_STATE = "lifecycle_msgs/srv/GetState"


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("lifecycle", help="Various lifecycle related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    nodes = verbs.add_parser("nodes", help="Output a list of nodes with lifecycle")
    nodes.add_argument("-c", "--count-nodes", action="store_true", help="Only display the number of nodes")
    nodes.add_argument("-a", "--all", action="store_true", help="Display all nodes even hidden ones")
    nodes.set_defaults(main=list_nodes)
    get = verbs.add_parser("get", help="Get lifecycle state for one or more nodes")
    get.add_argument("node_name", nargs="?", help="Name of the ROS node").completer = api.complete_by("lifecycle", "nodes")
    get.set_defaults(main=get_state)
    lister = verbs.add_parser("list", help="Output a list of available transitions")
    lister.add_argument("node_name", help="Name of the ROS node").completer = api.complete_by("lifecycle", "nodes")
    lister.add_argument("-a", "--all", action="store_true", help="Output all existing transitions")
    lister.set_defaults(main=list_transitions)
    setter = verbs.add_parser("set", help="Trigger lifecycle state transition")
    setter.add_argument("node_name", help="Name of the ROS node").completer = api.complete_by("lifecycle", "nodes")
    setter.add_argument("transition", help="The lifecycle transition: a label or a number")
    setter.set_defaults(main=set_state)
    for verb in (nodes, get, lister, setter):
        api.add_hidden_flag(verb, "nodes")


def _nodes(hidden: bool) -> list[str]:
    services = [name for name, types in api.services(hidden=True) if _GET_STATE in types]
    names = {name.removesuffix("/get_state") for name in services if name.endswith("/get_state")}
    return [name for name in api.node_names(hidden) if name in names]


def _ask(node: Node, name: str, kind: type[Any], service: str, request: object) -> Any:
    import rclpy

    client = node.create_client(kind, f"{name}/{service}")
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def _checked(args: Namespace) -> str:
    name = api.full_name(args.node_name)
    if name not in _nodes(args.hidden):
        raise api.Unhappy("Node not found")
    return name


def list_nodes(args: Namespace) -> int:
    """Print the lifecycle nodes."""
    names = _nodes(args.hidden or args.all)
    if args.count_nodes:
        print(len(names))
    else:
        for name in names:
            print(name)
    return 0


def get_state(args: Namespace) -> int:
    """Print the state of one node or of all."""
    from lifecycle_msgs.srv import GetState

    with api.command_node() as node:
        for name in [_checked(args)] if args.node_name else _nodes(args.hidden):
            state = _ask(node, name, GetState, "get_state", GetState.Request()).current_state
            prefix = "" if args.node_name else f"{name}: "
            print(f"{prefix}{state.label} [{state.id}]")
    return 0


def _transitions(node: Node, name: str, everything: bool = False) -> list[Any]:
    from lifecycle_msgs.srv import GetAvailableTransitions

    service = "get_transition_graph" if everything else "get_available_transitions"
    kind = GetAvailableTransitions
    return list(_ask(node, name, kind, service, kind.Request()).available_transitions)


def list_transitions(args: Namespace) -> int:
    """Print the transitions that are currently possible, or all."""
    with api.command_node() as node:
        for transition in _transitions(node, _checked(args), args.all):
            print(
                f"- {transition.transition.label} [{transition.transition.id}]\n"
                f"\tStart: {transition.start_state.label}\n\tGoal: {transition.goal_state.label}"
            )
    return 0


def set_state(args: Namespace) -> int:
    """Make a transition."""
    from lifecycle_msgs.msg import Transition
    from lifecycle_msgs.srv import ChangeState

    name = _checked(args)
    with api.command_node() as node:
        known = _transitions(node, name)
        wanted = [
            transition.transition
            for transition in known
            if args.transition in (transition.transition.label, str(transition.transition.id))
        ]
        if not wanted:
            names = "\n".join(f"- {transition.transition.label} [{transition.transition.id}]" for transition in known)
            raise api.Unhappy(f"Unknown transition requested, available ones are:\n{names}")
        request = ChangeState.Request(transition=Transition(id=wanted[0].id, label=wanted[0].label))
        if _ask(node, name, ChangeState, "change_state", request).success:
            print("Transitioning successful")
            return 0
    raise api.Unhappy("Transitioning failed")
