"""`ros2 interface list|package|packages|proto|show`."""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any

from coursekit.cli import api
from coursekit.cli.interface_text import shown

if TYPE_CHECKING:
    from argparse import Namespace


def register(subparsers: Any) -> None:
    """Add the command."""
    parser = subparsers.add_parser("interface", help="Show information about ROS interfaces")
    verbs = parser.add_subparsers(title="Verbs", dest="_verb", required=True)
    _register_lists(verbs)
    proto = verbs.add_parser("proto", help="Output an interface prototype")
    proto.add_argument("type", help="Show an interface definition (e.g. 'example_interfaces/msg/String')").completer = (
        _complete_any
    )
    proto.add_argument("--no-quotes", action="store_true", help="Output without surrounding quotes")
    proto.set_defaults(main=show_proto)
    show = verbs.add_parser("show", help="Output the interface definition")
    show.add_argument("type", help="Interface to show; '-' reads it from stdin").completer = _complete_any
    comments = show.add_mutually_exclusive_group()
    comments.add_argument("--all-comments", action="store_true", help="Show all comments, of nested interfaces too")
    comments.add_argument("--no-comments", action="store_true", help="Show no comments or whitespace")
    show.set_defaults(main=show_definition)


def _register_lists(verbs: Any) -> None:
    for name, main, text in (
        ("list", list_interfaces, "List all interface types available"),
        ("packages", list_packages, "Output a list of packages that provide interfaces"),
        ("package", list_package, "Output a list of available interface types within one package"),
    ):
        parser = verbs.add_parser(name, help=text)
        if name == "package":
            parser.add_argument("package_name", help="Name of the ROS package").completer = lambda **_: _packages()
        for letter, word in (("m", "msgs"), ("s", "srvs"), ("a", "actions")):
            parser.add_argument(f"-{letter}", f"--only-{word}", action="store_true", help=f"Only the {word}")
        parser.set_defaults(main=main)


def _complete_any(**_: Any) -> list[str]:
    from rosidl_runtime_py import get_interfaces

    return [f"{package}/{name}" for package, names in get_interfaces().items() for name in names]


def _packages() -> list[str]:
    from rosidl_runtime_py import get_interface_packages

    return sorted(get_interface_packages())


def _kinds(args: Namespace) -> list[tuple[str, str]]:
    """Return (title, kind) of the requested kinds; all if none is requested."""
    kinds = [("Messages", "msg"), ("Services", "srv"), ("Actions", "action")]
    only = [args.only_msgs, args.only_srvs, args.only_actions]
    return [kind for kind, wanted in zip(kinds, only, strict=True) if wanted or not any(only)]


def list_interfaces(args: Namespace) -> int:
    """Print every interface, by kind."""
    from rosidl_runtime_py import get_interfaces

    names_by_package = get_interfaces()
    for title, kind in _kinds(args):
        print(f"{title}:")
        for package in sorted(names_by_package):
            for name in names_by_package[package]:
                if name.startswith(f"{kind}/"):
                    print(f"    {package}/{name}")
    return 0


def list_packages(args: Namespace) -> int:
    """Print the packages with interfaces."""
    from rosidl_runtime_py import get_interfaces

    prefixes = tuple(f"{kind}/" for _, kind in _kinds(args))
    for package, names in sorted(get_interfaces().items()):
        if any(name.startswith(prefixes) for name in names):
            print(package)
    return 0


def list_package(args: Namespace) -> int:
    """Print the interfaces of a package."""
    from rosidl_runtime_py import get_interfaces

    if args.package_name not in _packages():
        raise api.Unhappy(f"Unknown package '{args.package_name}'")
    names = get_interfaces([args.package_name]).get(args.package_name, [])
    for _, kind in _kinds(args):
        for name in names:
            if name.startswith(f"{kind}/"):
                print(f"{args.package_name}/{name}")
    return 0


def show_proto(args: Namespace) -> int:
    """Print a message with its default values, as `ros2 topic pub` takes it."""
    quote = "" if args.no_quotes else '"'
    print(f"{quote}{api.prototype(args.type)}{quote}")
    return 0


def show_definition(args: Namespace) -> int:
    """Print the definition file, nested messages expanded."""
    name = sys.stdin.readline().strip() if args.type == "-" else args.type
    mode = "all" if args.all_comments else "none" if args.no_comments else "top"
    for line in shown(name, mode):
        print(line)
    return 0
