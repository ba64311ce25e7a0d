"""The common parts of the commands: a hidden node for each, and completion of graph names."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import yaml

from coursekit.core.graph import Graph
from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.rcl.names import is_hidden
from coursekit.suggestions import did_you_mean

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


class Unhappy(Exception):
    """Ends a command with a message on stderr and an exit code."""

    def __init__(self, text: str, code: int = 1) -> None:
        super().__init__(text)
        self.code = code


@contextlib.contextmanager
def command_node(name: str = "_ros2cli", **options: Any) -> Iterator[Any]:
    """Provide a hidden node for the duration of a command."""
    import rclpy

    process = current_process()
    rclpy.init(args=[])
    options.setdefault("start_parameter_services", False)
    options.setdefault("enable_rosout", False)
    node = rclpy.create_node(f"{name}_{process.pid if process else 0}", use_global_arguments=False, **options)
    try:
        yield node
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


def on_clock(args: Namespace) -> dict[str, Any]:
    """Return the node options for following /clock, if `--use-sim-time` was given."""
    from rclpy.parameter import Parameter

    simulated = getattr(args, "use_sim_time", False)
    return {"parameter_overrides": [Parameter("use_sim_time", value=True)]} if simulated else {}


def yaml_values(text: str) -> dict[str, Any]:
    """Parse fields typed as YAML.

    >>> yaml_values("{a: 1}")
    {'a': 1}

    Raises:
        Unhappy: when it is not YAML, or not a mapping.
    """
    fault = "The passed value needs to be a dictionary in YAML format"
    try:
        values = yaml.safe_load(text)
    except yaml.MarkedYAMLError as error:
        place = f" at character {error.problem_mark.index + 1}" if error.problem_mark else ""
        raise Unhappy(f"{fault}\n'{text}': {error.problem}{place}. Check its braces, colons and quotes.") from None
    except yaml.YAMLError as error:
        raise Unhappy(f"{fault}: {error}") from None
    if not isinstance(values, dict):
        raise Unhappy(fault)
    return values


WAIT_SECONDS = 5.0
"""How long a command waits as on a robot before it prints what it waits for, and the alternatives [s]."""
ENDS_WAITING = "Ctrl-C ends the waiting, in a notebook the stop button."


def say_missing(name: str, known: list[str], what: str) -> None:
    """Report that no node offers a service or an action, and suggest the name that was probably meant."""
    there = f"There are: {', '.join(known)}." if known else "There is none: does the program run that offers it?"
    meant = did_you_mean(name, known, there)
    say_error(f"Still waiting: no node offers the {what} {name}. {meant} {ENDS_WAITING}")


def graph() -> Graph:
    """Return the graph of this terminal's domain."""
    from .session_client import domain_id

    return current().graph(domain_id())


def full_name(name: str) -> str:
    """Return a name with its leading slash, which may be omitted.

    >>> full_name("scan"), full_name("/scan")
    ('/scan', '/scan')
    """
    return name if name.startswith("/") else f"/{name}"


def node_names(hidden: bool = False) -> list[str]:
    """Return the full names of the nodes in the graph, sorted."""
    return sorted(node.full_name for node in list(graph().nodes) if hidden or not is_hidden(node.full_name))


def find_node(name: str) -> Any:
    """Return the node of that full name; raises Unhappy with ROS's message."""
    for node in list(graph().nodes):
        if node.full_name == full_name(name):
            return node
    raise Unhappy("Node not found")


def topics(hidden: bool = False) -> list[tuple[str, list[str]]]:
    """Return (name, types) of the topics."""
    return [(name, types) for name, types in graph().topics() if hidden or not is_hidden(name)]


def services(hidden: bool = False) -> list[tuple[str, list[str]]]:
    """Return (name, types) of the services."""
    return [(name, types) for name, types in graph().services() if hidden or not is_hidden(name)]


def complete_by(*command: str) -> Any:
    """Complete by the names that `ros2 COMMAND` prints in the running session."""

    def complete(**_: Any) -> list[str]:
        from .session_client import answer

        return answer(command)

    return complete


complete_nodes = complete_by("node", "list")
complete_topics = complete_by("topic", "list")
complete_services = complete_by("service", "list")


def complete_values(typed: str) -> Any:
    """Complete by the default values of the type given in the argument `typed`."""

    def complete(parsed_args: Namespace, **_: Any) -> list[str]:
        return [prototype(getattr(parsed_args, typed))]

    return complete


def prototype(name: str) -> str:
    """Return the default values of a message, request or goal as YAML; raises Unhappy for an unknown type.

    >>> print(prototype("geometry_msgs/msg/Point"), end="")
    x: 0.0
    y: 0.0
    z: 0.0
    """
    from rosidl_runtime_py import message_to_yaml
    from rosidl_runtime_py.utilities import get_interface

    try:
        interface = get_interface(name)
    except (AttributeError, LookupError, ModuleNotFoundError, ValueError) as error:
        raise Unhappy(str(error)) from None
    for part in ("Request", "Goal"):
        interface = getattr(interface, part, interface)
    return str(message_to_yaml(interface()))


def complete_interfaces(kind: str) -> Any:
    """Complete by the names of 'msg', 'srv' or 'action' interfaces."""

    def complete(**_: Any) -> list[str]:
        from rosidl_runtime_py import get_interfaces

        return [f"{package}/{name}" for package, names in get_interfaces().items() for name in names if f"{kind}/" in name]

    return complete


def say_error(text: str) -> None:
    """Print a line on stderr."""
    print(text, file=sys.stderr)


def add_hidden_flag(parser: ArgumentParser, what: str) -> None:
    """Add the flag `--include-hidden-...`."""
    parser.add_argument(
        f"--include-hidden-{what}", action="store_true", dest="hidden", help=f"Consider hidden {what} as well"
    )
