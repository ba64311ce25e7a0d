"""`ros2 service list|type|find|call`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from coursekit.cli import api
from coursekit.cli.topic_pub import positive
from coursekit.core.graph import names_and_types
from coursekit.processes.session import current
from coursekit.rcl.names import is_hidden

if TYPE_CHECKING:
    from argparse import Namespace

    from rclpy.client import Client
    from rclpy.node import Node


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("service", help="Various service related sub-commands")
    api.add_hidden_flag(parser, "services")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    lister = verbs.add_parser("list", help="Output a list of available services")
    lister.add_argument("-t", "--show-types", action="store_true", help="Additionally show the service type")
    lister.add_argument("-c", "--count-services", action="store_true", help="Only display the number of services")
    lister.add_argument("--include-hidden-services", action="store_true", dest="hidden_too", help="Hidden ones too")
    lister.set_defaults(main=list_services)
    kind = verbs.add_parser("type", help="Output a service's type")
    kind.add_argument("service_name", help="Name of the ROS service").completer = api.complete_services
    kind.set_defaults(main=show_type)
    find = verbs.add_parser("find", help="Output a list of available services of a given type")
    find.add_argument("service_type", help="Type to filter for").completer = api.complete_interfaces("srv")
    find.add_argument("-c", "--count-services", action="store_true", help="Only display the number of services")
    find.add_argument("--include-hidden-services", action="store_true", dest="hidden_too", help="Hidden ones too")
    find.set_defaults(main=find_services)
    call = verbs.add_parser("call", help="Call a service")
    call.add_argument("service_name", help="Name of the ROS service").completer = api.complete_services
    call.add_argument("service_type", help="Type of the ROS service").completer = api.complete_interfaces("srv")
    values = call.add_argument("values", nargs="?", default="{}", help="Values to fill the request with in YAML format")
    values.completer = api.complete_values("service_type")
    call.add_argument("-r", "--rate", metavar="N", type=positive, help="Repeat the call at a specific rate in Hz")
    call.set_defaults(main=call_service)


def list_services(args: Namespace) -> int:
    """Print the services that have a server."""
    services = _served(args.hidden or args.hidden_too)
    if args.count_services:
        print(len(services))
        return 0
    for name, types in services:
        print(f"{name} [{', '.join(types)}]" if args.show_types else name)
    return 0


def _served(hidden: bool) -> list[tuple[str, list[str]]]:
    return api.services(hidden)


def show_type(args: Namespace) -> int:
    """Print a service's types."""
    types = dict(api.services(args.hidden)).get(api.full_name(args.service_name))
    for type_name in types or ():
        print(type_name)
    return 0 if types else 1


def find_services(args: Namespace) -> int:
    """Print the services of a type."""
    names = [name for name, types in _served(args.hidden or args.hidden_too) if args.service_type in types]
    if args.count_services:
        print(len(names))
    else:
        for name in names:
            print(name)
    return 0


def call_service(args: Namespace) -> int:
    """Send a request and print the response."""
    values = api.yaml_values(args.values)
    kind = _service_type(args.service_type)
    with api.command_node() as node:
        client = node.create_client(kind, args.service_name)
        request = _filled(kind.Request(), values)
        if not client.service_is_ready():
            print("waiting for service to become available...")
            _wait(client, api.full_name(args.service_name), args.service_type)
        while True:
            _call_once(node, client, request)
            if not args.rate:
                return 0
            current().clock.sleep(1.0 / args.rate)


def _service_type(name: str) -> Any:
    from rosidl_runtime_py.utilities import get_service

    try:
        return get_service(name)
    except (AttributeError, ModuleNotFoundError, ValueError):
        raise api.Unhappy("The passed service type is invalid") from None


def _wait(client: Client, name: str, kind: str) -> None:
    """Wait without a limit, as on a robot; after a while print the reason."""
    if client.wait_for_service(api.WAIT_SECONDS):
        return
    offered = dict(names_and_types([server for node in api.graph().nodes for server in node.servers]))
    if name in offered:
        api.say_error(f"Still waiting: {name} has the type {', '.join(offered[name])}, not {kind}. {api.ENDS_WAITING}")
    else:
        own = [
            service
            for service, types in offered.items()
            if not is_hidden(service) and not types[0].startswith("rcl_interfaces/")
        ]
        api.say_missing(name, own, "service")
    client.wait_for_service()


def _filled(request: object, values: dict[str, Any]) -> object:
    from rosidl_runtime_py import set_message_fields

    try:
        set_message_fields(request, values)
    except Exception as error:
        raise api.Unhappy(f"Failed to populate field: {error}") from None
    return request


def _call_once(node: Node, client: Client, request: object) -> None:
    import rclpy

    print(f"requester: making request: {request!r}\n")
    future = client.call_async(request)
    rclpy.spin_until_future_complete(node, future, timeout_sec=api.WAIT_SECONDS)
    if not future.done():
        api.say_error(f"Still waiting for the response. {_silence(client)} {api.ENDS_WAITING}")
        rclpy.spin_until_future_complete(node, future)
    if future.result() is None:
        raise api.Unhappy(f"Exception while calling service: {future.exception()!r}")
    print(f"response:\n{future.result()!r}\n")


def _silence(client: Client) -> str:
    """Return the probable reason for a missing response."""
    if client.service_is_ready():
        return "A node offers the service, but does not answer: is it busy, or does nothing spin it?"
    return "Nobody offers the service any more: the server's program has ended, and its terminal says why."
