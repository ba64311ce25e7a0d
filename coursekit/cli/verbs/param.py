"""`ros2 param list|get|set|describe|dump|load|delete`."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from coursekit.cli import api, param_text
from coursekit.files import write_whole

if TYPE_CHECKING:
    from argparse import Namespace
    from collections.abc import Callable

    from rclpy.node import Node

_SERVICES = "rcl_interfaces/srv/ListParameters"


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("param", help="Various param related sub-commands")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    lister = _verb(verbs, "list", "Output a list of available parameters", list_parameters, node="?")
    lister.add_argument("--param-prefixes", nargs="+", default=[], help="Only names with these prefixes")
    lister.add_argument("--param-type", action="store_true", help="Print the types too")
    lister.add_argument("--filter", default="", help="Only names that match this regular expression")
    get = _verb(verbs, "get", "Get parameter", get_parameter)
    _parameter_name(get)
    get.add_argument("--hide-type", action="store_true", help="Hide the type information")
    setter = _verb(verbs, "set", "Set parameter", set_parameter)
    _parameter_name(setter)
    setter.add_argument("value", help="Value of the parameter")
    describe = _verb(verbs, "describe", "Show descriptive information about declared parameters", describe_parameters)
    describe.add_argument("parameter_names", nargs="+", help="Names of the parameters").completer = _complete_names
    dump = _verb(verbs, "dump", "Show all of the parameters of a node in a YAML file format", dump_parameters)
    dump.add_argument("--output-dir", default=None, help="Save to a file in this folder instead")
    dump.add_argument("--print", action="store_true", help="DEPRECATED: Does nothing")
    load = _verb(verbs, "load", "Load parameter file for a node", load_parameters)
    load.add_argument("parameter_file", help="Parameter file")
    load.add_argument("--no-use-wildcard", action="store_true", help="Do not load parameters in the '/**' namespace")
    _parameter_name(_verb(verbs, "delete", "Delete parameter", delete_parameter))


def _verb(verbs: Any, name: str, text: str, main: Callable[[Namespace], int], node: str | None = None) -> Any:
    parser = verbs.add_parser(name, help=text)
    parser.add_argument("node_name", nargs=node, help="Name of the ROS node").completer = api.complete_nodes
    api.add_hidden_flag(parser, "nodes")
    parser.set_defaults(main=main)
    return parser


def _parameter_name(parser: Any) -> None:
    parser.add_argument("parameter_name", help="Name of the parameter").completer = _complete_names


def _complete_names(parsed_args: Namespace, **_: Any) -> list[str]:
    return api.complete_by("param", "list", parsed_args.node_name)()  # type: ignore[no-any-return]


class _Asking:
    """Calls a node's parameter services and waits for the responses."""

    def __init__(self, node: Node, name: str) -> None:
        from rclpy.parameter_client import AsyncParameterClient

        api.find_node(name)
        self.name = api.full_name(name)
        self._node = node
        self._client = AsyncParameterClient(node, self.name)
        if not self._client.wait_for_services(timeout_sec=5.0):
            raise api.Unhappy("Wait for service timed out waiting for parameter services for node " + self.name)

    def __call__(self, method: str, *arguments: Any, **options: Any) -> Any:
        """Return the response of one of the client's methods."""
        import rclpy

        future = getattr(self._client, method)(*arguments, **options)
        rclpy.spin_until_future_complete(self._node, future)
        if future.result() is None:
            raise api.Unhappy(f"Exception while calling service of node '{self.name}': {future.exception()}")
        return future.result()

    def names(self, prefixes: list[str] | None = None) -> list[str]:
        """Return the names of the node's parameters, sorted."""
        return sorted(self("list_parameters", prefixes or [], 0).result.names)

    def values(self, names: list[str]) -> list[Any]:
        """Return the ParameterValues of these parameters."""
        return list(self("get_parameters", names).values)


def _nodes(args: Namespace) -> list[str]:
    if args.node_name:
        return [api.full_name(args.node_name)]
    serving = {name.rpartition("/")[0] for name, types in api.services(hidden=True) if _SERVICES in types}
    return [name for name in api.node_names(args.hidden) if name in serving]


def list_parameters(args: Namespace) -> int:
    """Print the parameter names of one node, or of all nodes."""
    import re

    with api.command_node() as node:
        for name in _nodes(args):
            asking = _Asking(node, name)
            names = [parameter for parameter in asking.names(args.param_prefixes) if re.search(args.filter, parameter)]
            if not args.node_name:
                print(f"{name}:")
            values = asking.values(names) if args.param_type else [None] * len(names)
            for parameter, value in zip(names, values, strict=True):
                print(f"  {parameter} (type: {param_text.type_name(value.type)})" if value is not None else f"  {parameter}")
    return 0


def get_parameter(args: Namespace) -> int:
    """Print a parameter's value."""
    with api.command_node() as node:
        values = _Asking(node, args.node_name).values([args.parameter_name])
    label, value = param_text.labelled(values[0]) if values else (None, None)
    if label is None:
        print("Parameter not set.")
    else:
        print(value if args.hide_type else f"{label} {value}")
    return 0


def set_parameter(args: Namespace) -> int:
    """Set a parameter; the value's type is inferred from its text, as in YAML."""
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    parameter = Parameter(name=args.parameter_name, value=get_parameter_value(args.value))
    with api.command_node() as node:
        result = _Asking(node, args.node_name)("set_parameters", [parameter]).results[0]
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print(f"Set parameter successful{reason}")
    else:
        print(f"Setting parameter failed{reason}", file=sys.stderr)
    return 0


def describe_parameters(args: Namespace) -> int:
    """Print types, descriptions and constraints."""
    with api.command_node() as node:
        descriptors = _Asking(node, args.node_name)("describe_parameters", args.parameter_names).descriptors
    for descriptor in descriptors:
        print(param_text.described(descriptor))
    return 0


def dump_parameters(args: Namespace) -> int:
    """Print, or save, a file that reproduces the node's current parameters."""
    if args.output_dir is not None and not Path(args.output_dir).is_dir():
        raise api.Unhappy(f"'{args.output_dir}' is not a valid directory.")
    if args.print:
        api.say_error("WARNING: '--print' is deprecated; this utility prints to stdout by default")
    with api.command_node() as node:
        asking = _Asking(node, args.node_name)
        names = asking.names()
        text = param_text.dumped(asking.name, names, asking.values(names))
    if args.output_dir is None:
        print(text)
        return 0
    file = Path(args.output_dir) / (asking.name.strip("/").replace("/", "__") + ".yaml")
    print("Saving to: ", file)
    write_whole(file, text)
    return 0


def load_parameters(args: Namespace) -> int:
    """Set the node's parameters from a file."""
    from rclpy.parameter import parameter_dict_from_yaml_file

    with api.command_node() as node:
        asking = _Asking(node, args.node_name)
        try:
            _check_named(args.parameter_file, asking.name, not args.no_use_wildcard)
            parameters = parameter_dict_from_yaml_file(
                args.parameter_file, not args.no_use_wildcard, target_nodes=[asking.name]
            )
        except (OSError, RuntimeError, ValueError, yaml.YAMLError) as error:
            raise api.Unhappy(str(error)) from None
        results = asking("set_parameters", list(parameters.values())).results
    for name, result in zip(parameters, results, strict=True):
        reason = f": {result.reason}" if result.reason else ""
        if result.successful:
            print(f"Set parameter {name} successful{reason}")
        else:
            print(f"Set parameter {name} failed{reason}", file=sys.stderr)
    return 0


def _check_named(path: str, node: str, use_wildcard: bool) -> None:
    """Raise RuntimeError unless a file has the node's full name with its leading slash, or a permitted wildcard."""
    tree = yaml.safe_load(Path(path).read_text(encoding="utf-8"))
    names = list(tree) if isinstance(tree, dict) else []
    if node not in names and not (use_wildcard and "/**" in names):
        raise RuntimeError(f"Param file does not contain parameters for {node},  only for nodes: {names}")


def delete_parameter(args: Namespace) -> int:
    """Delete a parameter's value."""
    with api.command_node() as node:
        result = _Asking(node, args.node_name)("delete_parameters", [args.parameter_name]).results[0]
    reason = f": {result.reason}" if result.reason else ""
    if result.successful:
        print(f"Deleted parameter successfully{reason}")
        return 0
    print(f"Deleting parameter failed{reason}", file=sys.stderr)
    return 1
