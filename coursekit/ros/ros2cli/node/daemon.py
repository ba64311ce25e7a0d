"""The daemon's knowledge of the graph."""

from __future__ import annotations

from types import SimpleNamespace
from typing import TYPE_CHECKING, Any

from rclpy._node_graph import NodeGraph
from rclpy.action import graph as action_graph

from coursekit.cli import api, daemon
from ros2cli.helpers import get_ros_domain_id

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace

_METHODS = [
    *(name for name in vars(NodeGraph) if name.startswith(("get_", "count_"))),
    *(name for name in vars(action_graph) if name.startswith("get_")),
    "get_name",
    "get_namespace",
]


class _View(NodeGraph):
    """A view of the graph without a node in it."""

    def __init__(self) -> None:
        graph: Any = api.graph()
        self._rclpy_graph_node = SimpleNamespace(graph=graph)
        self.handle = SimpleNamespace(check=lambda: None, resolve=lambda name, _kind: name)

    def get_name(self) -> str:
        """The daemon's name."""
        return f"_ros2cli_daemon_{get_ros_domain_id()}"

    def get_namespace(self) -> str:
        """The daemon's namespace."""
        return "/"


class DaemonNode:
    """Answers as the daemon does, with lists where a node returns tuples."""

    def __init__(self, args: Namespace) -> None:
        self._args = args
        self._view = _View()
        self.system = SimpleNamespace(shutdown=lambda: shutdown_daemon(args), list_methods=lambda: self.methods)

    @property
    def connected(self) -> bool:
        """Whether the daemon runs."""
        return is_daemon_running(self._args)

    @property
    def methods(self) -> list[str]:
        """The names of the daemon's functions."""
        return list(_METHODS)

    def __getattr__(self, name: str) -> Any:
        if name not in _METHODS:
            raise AttributeError(f"the daemon has no '{name}'; it has {', '.join(_METHODS)}")
        if hasattr(action_graph, name):
            return lambda *words: _lists(getattr(action_graph, name)(self._view, *words))
        return lambda *words: _lists(getattr(self._view, name)(*words))

    def __enter__(self) -> DaemonNode:
        return self

    def __exit__(self, *_error: object) -> None:
        """Do nothing: there is nothing to release."""


def _lists(answer: Any) -> Any:
    return [_lists(each) for each in answer] if isinstance(answer, (list, tuple)) else answer


def is_daemon_running(args: Namespace) -> bool:
    """Whether the daemon runs."""
    return daemon.is_running(api.graph())


def spawn_daemon(args: Namespace, timeout: float | None = None, debug: bool = False) -> bool:
    """Start the daemon; return False if it is already running."""
    return daemon.start(api.graph(), get_ros_domain_id())


def shutdown_daemon(args: Namespace, timeout: float | None = None) -> bool:
    """Stop the daemon; return False if it is not running."""
    return daemon.stop(api.graph())


def add_arguments(parser: ArgumentParser) -> None:
    """Add the option `--no-daemon`."""
    parser.add_argument("--no-daemon", action="store_true", help="Do not spawn nor use an already running daemon")
