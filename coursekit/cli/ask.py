"""The common parts of the commands: a hidden node of their own, and names of the graph for completion."""

from __future__ import annotations

import contextlib
import sys
from collections.abc import Iterator
from typing import Any

import yaml

from coursekit.core.graph import Graph
from coursekit.processes.process import current_process
from coursekit.processes.session import current
from coursekit.rcl.names import is_hidden
from coursekit.suggestions import did_you_mean


class Unhappy(Exception):
    """Ends a command with a text on stderr and an exit code."""

    def __init__(self, text: str, code: int = 1) -> None:
        super().__init__(text)
        self.code = code


@contextlib.contextmanager
def command_node(name: str = "_ros2cli", **options: Any) -> Iterator[Any]:
    """A hidden node for the time of a command."""
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


def on_clock(args: Any) -> dict[str, Any]:
    """The options by which a command's node follows /clock, if `--use-sim-time` was given."""
    from rclpy.parameter import Parameter

    simulated = getattr(args, "use_sim_time", False)
    return {"parameter_overrides": [Parameter("use_sim_time", value=True)]} if simulated else {}


def yaml_values(text: str) -> dict[str, Any]:
    """The fields that were typed as YAML.

    >>> yaml_values("{a: 1}")
    {'a': 1}

    Raises:
        Unhappy: when it is no YAML, or no fields with values.
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
"""So long a command waits as on a robot; then it says what it waits for, and what there is instead."""
ENDS_WAITING = "Ctrl-C ends the waiting, in a notebook the stop button."


def say_missing(name: str, known: list[str], what: str) -> None:
    """Say that nobody offers a service or an action, and which name was probably meant."""
    there = f"There are: {', '.join(known)}." if known else "There is none: does the program run that offers it?"
    meant = did_you_mean(name, known, there)
    say_error(f"Still waiting: no node offers the {what} {name}. {meant} {ENDS_WAITING}")


def graph() -> Graph:
    """The graph of this terminal's domain."""
    from .attach import domain_id

    return current().graph(domain_id())


def full_name(name: str) -> str:
    """A name with the leading slash that may be left out."""
    return name if name.startswith("/") else f"/{name}"


def node_names(hidden: bool = False) -> list[str]:
    """The full names of the nodes in the graph, sorted."""
    return sorted(node.full_name for node in list(graph().nodes) if hidden or not is_hidden(node.full_name))


def find_node(name: str) -> Any:
    """The node of that full name; raises Unhappy with ROS's text."""
    for node in list(graph().nodes):
        if node.full_name == full_name(name):
            return node
    raise Unhappy("Node not found")


def topics(hidden: bool = False) -> list[tuple[str, list[str]]]:
    """(name, types) of the topics."""
    return [(name, types) for name, types in graph().topics() if hidden or not is_hidden(name)]


def services(hidden: bool = False) -> list[tuple[str, list[str]]]:
    """(name, types) of the services."""
    return [(name, types) for name, types in graph().services() if hidden or not is_hidden(name)]


def complete_by(*command: str) -> Any:
    """For tab completion: the names that `ros2 COMMAND` prints in the session that runs."""

    def complete(**_: Any) -> list[str]:
        from .attach import answer

        return answer(command)

    return complete


complete_nodes = complete_by("node", "list")
complete_topics = complete_by("topic", "list")
complete_services = complete_by("service", "list")


def complete_values(typed: str) -> Any:
    """For tab completion: the default values of the type that the argument `typed` names."""

    def complete(parsed_args: Any, **_: Any) -> list[str]:
        return [prototype(getattr(parsed_args, typed))]

    return complete


def prototype(name: str) -> str:
    """The default values of a message, a request or a goal as YAML; raises Unhappy when there is no such type."""
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
    """For tab completion: names of 'msg', 'srv' or 'action' interfaces."""

    def complete(**_: Any) -> list[str]:
        from rosidl_runtime_py import get_interfaces

        return [f"{package}/{name}" for package, names in get_interfaces().items() for name in names if f"{kind}/" in name]

    return complete


def say_error(text: str) -> None:
    """A line on stderr."""
    print(text, file=sys.stderr)


def add_hidden_flag(parser: Any, what: str) -> None:
    """`--include-hidden-...`."""
    parser.add_argument(
        f"--include-hidden-{what}", action="store_true", dest="hidden", help=f"Consider hidden {what} as well"
    )
