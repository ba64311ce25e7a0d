"""`ros2 action list|info|type|send_goal`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli import api

if TYPE_CHECKING:
    from argparse import Namespace
    from collections.abc import Callable

    from rclpy.action import ActionClient
    from rclpy.node import Node
    from rclpy.task import Future


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("action", help="Various action related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    lister = verbs.add_parser("list", help="Output a list of action names")
    lister.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    lister.add_argument("-c", "--count-actions", action="store_true", help="Only display the number of actions")
    lister.set_defaults(main=list_actions)
    info = verbs.add_parser("info", help="Print information about an action")
    info.add_argument("action_name", help="Name of the ROS action").completer = api.complete_by("action", "list")
    info.add_argument("-t", "--show-types", action="store_true", help="Additionally show the action type")
    info.add_argument("-c", "--count", action="store_true", help="Only display the number of clients and servers")
    info.set_defaults(main=show_info)
    kind = verbs.add_parser("type", help="Print an action's type")
    kind.add_argument("action_name", help="Name of the ROS action").completer = api.complete_by("action", "list")
    kind.set_defaults(main=show_type)
    send = verbs.add_parser("send_goal", help="Send an action goal")
    send.add_argument("action_name", help="Name of the ROS action").completer = api.complete_by("action", "list")
    send.add_argument("action_type", help="Type of the ROS action").completer = api.complete_interfaces("action")
    goal = send.add_argument("goal", help="Goal request values in YAML format")
    goal.completer = api.complete_values("action_type")
    send.add_argument("-f", "--feedback", action="store_true", help="Echo feedback messages for the goal")
    send.set_defaults(main=send_goal)


def _actions() -> list[tuple[str, list[str]]]:
    from rclpy.action import get_action_names_and_types

    with api.command_node() as node:
        return list(get_action_names_and_types(node))


def list_actions(args: Namespace) -> int:
    """Print the actions."""
    actions = _actions()
    if args.count_actions:
        print(len(actions))
        return 0
    for name, types in actions:
        print(f"{name} [{', '.join(types)}]" if args.show_types else name)
    return 0


def show_type(args: Namespace) -> int:
    """Print an action's types."""
    types = dict(_actions()).get(api.full_name(args.action_name))
    for type_name in types or ():
        print(type_name)
    return 0 if types else 1


def show_info(args: Namespace) -> int:
    """Print the servers and clients of an action."""
    from rclpy.action import get_action_client_names_and_types_by_node, get_action_server_names_and_types_by_node

    name = api.full_name(args.action_name)
    print(f"Action: {name}")
    with api.command_node() as node:
        for title, find in (
            ("Action clients", get_action_client_names_and_types_by_node),
            ("Action servers", get_action_server_names_and_types_by_node),
        ):
            nodes = _nodes_with(node, name, find)
            print(f"{title}: {len(nodes)}")
            for full_name, types in nodes if not args.count else ():
                print(f"    {full_name} [{', '.join(types)}]" if args.show_types else f"    {full_name}")
    return 0


def _nodes_with(
    node: Node, action: str, find: Callable[[Node, str, str], list[tuple[str, list[str]]]]
) -> list[tuple[str, list[str]]]:
    nodes = []
    for other in list(api.graph().nodes):
        types = dict(find(node, other.name, other.namespace)).get(action)
        if types:
            nodes.append((other.full_name, types))
    return sorted(nodes)


def send_goal(args: Namespace) -> int:
    """Send a goal, print its feedback if requested, and its result; Ctrl-C cancels it."""
    from rclpy.action import ActionClient
    from rclpy.signals import SignalHandlerOptions, install_signal_handlers
    from rosidl_runtime_py import set_message_fields
    from rosidl_runtime_py.utilities import get_action

    try:
        kind = get_action(args.action_type)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise api.Unhappy("The passed action type is invalid") from None
    values = api.yaml_values(args.goal or "{}")
    goal = kind.Goal()
    try:
        set_message_fields(goal, values)
    except Exception as error:
        raise api.Unhappy(f"Failed to populate message fields: {error!r}") from None
    with api.command_node() as node:
        install_signal_handlers(SignalHandlerOptions.NO)  # Ctrl-C leaves the node alive, to cancel the goal
        client = ActionClient(node, kind, args.action_name)
        try:
            return _Sending(node, client, api.full_name(args.action_name), args.feedback).run(goal)
        finally:
            client.destroy()


def _offered(node: Node) -> list[str]:
    """Return the names of the actions that have a server."""
    from rclpy.action import get_action_server_names_and_types_by_node

    nodes = list(api.graph().nodes)
    return sorted(
        {name for other in nodes for name, _ in get_action_server_names_and_types_by_node(node, other.name, other.namespace)}
    )


class _Sending:
    """One goal in progress."""

    def __init__(self, node: Node, client: ActionClient, name: str, feedback: bool) -> None:
        self._node = node
        self._client = client
        self._name = name
        self._feedback = self._show_feedback if feedback else None
        self._handle: Any = None

    def _finish(self, future: Future) -> Any:
        import rclpy

        rclpy.spin_until_future_complete(self._node, future)
        return future.result()

    def _show_feedback(self, message: Any) -> None:
        from rosidl_runtime_py import message_to_yaml

        print(f"Feedback:\n    {message_to_yaml(message.feedback)}")

    def run(self, goal: Any) -> int:
        """Send the goal, wait for its result and print it."""
        from rosidl_runtime_py import message_to_yaml

        print("Waiting for an action server to become available...")
        if not self._client.wait_for_server(api.WAIT_SECONDS):
            api.say_missing(self._name, _offered(self._node), "action")
            self._client.wait_for_server()
        print(f"Sending goal:\n     {message_to_yaml(goal)}")
        self._handle = self._finish(self._client.send_goal_async(goal, self._feedback))
        if not self._handle.accepted:
            print("Goal was rejected.")
            return 1
        print(f"Goal accepted with ID: {bytes(self._handle.goal_id.uuid).hex()}\n")
        try:
            return self._show_result(self._finish(self._handle.get_result_async()))
        except KeyboardInterrupt:
            return self._cancel()

    def _show_result(self, response: Any) -> int:
        from action_msgs.msg import GoalStatus
        from rosidl_runtime_py import message_to_yaml

        print(f"Result:\n    {message_to_yaml(response.result)}")
        names = ("UNKNOWN", "ACCEPTED", "EXECUTING", "CANCELING", "SUCCEEDED", "CANCELED", "ABORTED")
        status = next(name for name in names if getattr(GoalStatus, f"STATUS_{name}") == response.status)
        print(f"Goal finished with status: {status}")
        return 0

    def _cancel(self) -> int:
        print("Canceling goal...")
        response = self._finish(self._handle.cancel_goal_async())
        print("Goal canceled." if response is not None and response.goals_canceling else "Failed to cancel goal")
        return 0
