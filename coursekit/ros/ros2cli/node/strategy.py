"""The daemon if it runs, else a node of the command's own."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ros2cli.node import daemon, direct
from ros2cli.node.daemon import DaemonNode, is_daemon_running, spawn_daemon
from ros2cli.node.direct import DirectNode

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


class NodeStrategy:
    """Forwards calls to the daemon if it knows them, otherwise to a node that is created on demand.

    >>> with NodeStrategy([]) as node:
    ...     node.get_namespace()
    '/'
    """

    def __init__(self, args: Namespace, *, node_name: str | None = None) -> None:
        self._args = args
        self._node_name = node_name
        self._daemon_node: DaemonNode | None = None
        self._direct_node: DirectNode | None = None
        use_daemon = not getattr(args, "no_daemon", False)
        if use_daemon and is_daemon_running(args):
            self._daemon_node = DaemonNode(args)
        else:
            self._direct_node = DirectNode(args, node_name=node_name)
            if use_daemon:
                spawn_daemon(args)

    @property
    def daemon_node(self) -> DaemonNode | None:
        """The daemon, if it is used."""
        return self._daemon_node

    @property
    def direct_node(self) -> DirectNode:
        """The command's own node, created on first use."""
        if self._direct_node is None:
            self._direct_node = DirectNode(self._args, node_name=self._node_name)
        return self._direct_node

    def __enter__(self) -> NodeStrategy:
        return self

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__") and name.endswith("__"):
            raise AttributeError(name)
        if self._daemon_node is not None and name in self._daemon_node.methods:
            return getattr(self._daemon_node, name)
        return getattr(self.direct_node, name)

    def __exit__(self, *error: object) -> None:
        if self._direct_node is not None:
            self._direct_node.__exit__(*error)


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options of the command's own node and of the daemon."""
    direct.add_arguments(parser)
    daemon.add_arguments(parser)
