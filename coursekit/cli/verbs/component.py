"""`ros2 component list|load|unload|standalone|types`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from coursekit.cli import api
from coursekit.nodes.running import pass_on_output
from coursekit.processes.components import registered
from coursekit.processes.executables import find, packages
from coursekit.processes.session import current

if TYPE_CHECKING:
    import argparse
    from argparse import Namespace

_SERVICES = {
    "load_node": "composition_interfaces/srv/LoadNode",
    "unload_node": "composition_interfaces/srv/UnloadNode",
    "list_nodes": "composition_interfaces/srv/ListNodes",
}


def register(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add the command."""
    parser = subparsers.add_parser("component", help="Various component related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    lister = verbs.add_parser("list", help="Output a list of running containers and components")
    lister.add_argument("container_node_name", nargs="?", help="Name of the container node to list components from")
    lister.add_argument("--containers-only", action="store_true", help="List found containers nodes only")
    lister.set_defaults(main=list_components)
    load = verbs.add_parser("load", help="Load a component into a container node")
    load.add_argument("container_node_name", help="Container node name to load component into")
    load.add_argument("-q", "--quiet", action="store_true", help="Only print component unique ID and name")
    _add_component(load)
    load.set_defaults(main=load_component)
    alone = verbs.add_parser("standalone", help="Run a component into its own standalone container node")
    alone.add_argument("-c", "--container-node-name", help="Name of the standalone container node to be run")
    _add_component(alone)
    alone.set_defaults(main=run_standalone)
    types = verbs.add_parser("types", help="Output a list of components registered in the ament index")
    types.add_argument("package_name", nargs="?", help="Optional package name to narrow down the list")
    types.set_defaults(main=show_types)
    unload = verbs.add_parser("unload", help="Unload a component from a container node")
    unload.add_argument("container_node_name", help="Container node name to unload component from")
    unload.add_argument("component_uid", type=int, nargs="+", help="Unique ID of the component to be unloaded")
    unload.add_argument("-q", "--quiet", action="store_true", help="Only print component unique IDs")
    unload.set_defaults(main=unload_components)


def _add_component(verb: argparse.ArgumentParser) -> None:
    verb.add_argument("package_name", help="Name of the package where the component is to be found")
    verb.add_argument("plugin_name", help="Type name of the component to be loaded")
    verb.add_argument("-n", "--node-name", default="", help="Component node name")
    verb.add_argument("--node-namespace", default="", help="Component node namespace")
    verb.add_argument("--log-level", help="Component node log level")
    for flags, name, text in (
        (("-r", "--remap-rule"), "remap_rules", "Component node remapping rules, in the 'from:=to' form"),
        (("-p", "--parameter"), "parameters", "Component node parameters, in the 'name:=value' form"),
        (("-e", "--extra-argument"), "extra_arguments", "Extra arguments for the container, in the 'name:=value' form"),
    ):
        verb.add_argument(*flags, action="append", default=[], dest=name, help=text)


def _containers() -> list[str]:
    served = dict(api.services(hidden=True))
    return [
        name
        for name in api.node_names()
        if all(kind in served.get(f"{name}/_container/{service}", ()) for service, kind in _SERVICES.items())
    ]


def _checked(name: str) -> str:
    if name not in _containers():
        raise api.Unhappy(f"Unable to find container node '{name}'")
    return name


def _call(container: str, service: str, **fields: Any) -> Any:
    import rclpy
    from rosidl_runtime_py.utilities import get_service

    kind: Any = get_service(_SERVICES[service])
    with api.command_node() as node:
        client = node.create_client(kind, f"{container}/_container/{service}")
        if not client.wait_for_service(timeout_sec=5.0):
            raise api.Unhappy(f"No '{service}' service found for '{container}' container")
        future = client.call_async(kind.Request(**fields))
        rclpy.spin_until_future_complete(node, future)
        return future.result()


def list_components(args: Namespace) -> int:
    """Print the containers and their components."""
    container = args.container_node_name
    for name in _containers() if container is None else [_checked(container)]:
        if container is None:
            print(name)
        if not args.containers_only:
            answer = _call(name, "list_nodes")
            for uid, node in zip(answer.unique_ids, answer.full_node_names, strict=True):
                print(f"{'  ' if container is None else ''}{uid}  {node}")
    return 0


def _parameters(assignments: Sequence[str]) -> list[Any]:
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    parts = [assignment.partition(":=") for assignment in assignments]
    return [Parameter(name=name, value=get_parameter_value(value)) for name, _, value in parts]


def _load(container: str, args: Namespace) -> Any:
    answer = _call(
        container,
        "load_node",
        package_name=args.package_name,
        plugin_name=args.plugin_name,
        node_name=args.node_name,
        node_namespace=args.node_namespace,
        log_level=int(args.log_level or 0),
        remap_rules=args.remap_rules,
        parameters=_parameters(args.parameters),
        extra_arguments=_parameters(args.extra_arguments),
    )
    if not answer.success:
        raise api.Unhappy(f"Failed to load component: {answer.error_message[:1].upper()}{answer.error_message[1:]}")
    return answer


def load_component(args: Namespace) -> int:
    """Load a component into a running container."""
    answer = _load(_checked(args.container_node_name), args)
    uid, name = answer.unique_id, answer.full_node_name
    text = f"Loaded component {uid} into '{args.container_node_name}' container node as '{name}'"
    print(f"{uid}  {name}" if args.quiet else text)
    return 0


def unload_components(args: Namespace) -> int:
    """Unload components from a container."""
    container = _checked(args.container_node_name)
    for uid in args.component_uid:
        answer = _call(container, "unload_node", unique_id=uid)
        if not answer.success:
            reason = answer.error_message.capitalize()
            raise api.Unhappy(f"Failed to unload component {uid} from '{container}' container node\n    {reason}")
        print(uid if args.quiet else f"Unloaded component {uid} from '{container}' container node")
    return 0


def run_standalone(args: Namespace) -> int:
    """Run a component in its own container until Ctrl-C."""
    name = args.container_node_name or f"standalone_container_{current().new_uuid().hex()[:12]}"
    words = ["--ros-args", "-r", f"__node:={name}"]
    path = find("rclcpp_components", "component_container")
    container = current().start_executable(path, words, on_output=pass_on_output())
    try:
        _load(f"/{name}", args)
    except api.Unhappy as error:
        print(f"{error}, terminating container.")
        container.interrupt()
    try:
        container.wait()
    except KeyboardInterrupt:
        container.interrupt()
        container.wait(5.0)
    return int(container.exit_code or 0)


def show_types(args: Namespace) -> int:
    """Print the components registered by packages."""
    types_by_package = registered()
    if args.package_name is not None:
        if args.package_name not in packages():
            raise api.Unhappy(f"Unable to find package '{args.package_name}'")
        for name in types_by_package.get(args.package_name, {}):
            print(name)
        return 0
    for package, types in types_by_package.items():
        print(package, *(f"  {name}" for name in types), sep="\n")
    return 0
