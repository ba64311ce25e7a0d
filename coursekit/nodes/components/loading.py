"""A loaded component: its process and its node."""

from __future__ import annotations

import signal
import time
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from composition_interfaces.srv import LoadNode
from rclpy.impl.logging_state import share_levels
from rclpy.parameter import Parameter

from coursekit.nodes.running import pass_on_output
from coursekit.processes.components import Given, give_to_first_node, share_told_signals
from coursekit.processes.executables import make_process
from coursekit.processes.session import current

PATIENCE = 10.0  # seconds until a component must have its node
_LEVELS = {10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal"}


def given_by(request: LoadNode.Request) -> Given:
    """Return the node options for a request."""
    return Given(arguments_of(request), [Parameter.from_parameter_msg(parameter) for parameter in request.parameters])


def arguments_of(request: LoadNode.Request) -> list[str]:
    """Return the options of the component's node as command-line arguments.

    >>> arguments_of(LoadNode.Request(node_name="tom", remap_rules=["chatter:=chat"]))
    ['--ros-args', '-r', '__node:=tom', '-r', 'chatter:=chat']
    """
    rules = [f"__node:={request.node_name}"] if request.node_name else []
    rules += [f"__ns:={request.node_namespace}"] if request.node_namespace else []
    words = ["--ros-args"]
    for rule in [*rules, *request.remap_rules]:
        words += ["-r", rule]
    return words


class LoadedComponent:
    """Starts a component's program as a part of the container: its output and command line are the container's.

    As in ROS 2, the component's node uses the given options, and other nodes of the program the container's command
    line. Raises RuntimeError when the program ends, or has no node after ten seconds.
    """

    def __init__(self, path: Path, given: Given, graph: Any, words: Sequence[str] = (), log_level: int = 0) -> None:
        level = ["--ros-args", "--log-level", _LEVELS[log_level]] if log_level in _LEVELS else []
        self.process = make_process(current(), path, [*words, *level])
        if not level:
            share_levels(self.process)
        give_to_first_node(self.process, given)
        current().launch(self.process, pass_on_output())
        self.full_name = self._wait_for_node(graph)

    def _wait_for_node(self, graph: Any) -> str:
        for _ in range(round(PATIENCE / 0.01)):
            names = [node.full_name for node in list(graph.nodes) if node.process is self.process]
            if names:
                return str(names[0])
            if self.process.exit_code == 0:
                raise RuntimeError("Component shut down as soon as it was made")
            if self.process.exit_code is not None:
                raise RuntimeError(f"Component constructor threw an exception: it ended with {self.process.exit_code}")
            time.sleep(0.01)
        self.unload()
        raise RuntimeError(f"Component has no node after {PATIENCE:.0f} s")

    def unload(self) -> None:
        """End the program as Ctrl-C does; but nobody pressed Ctrl-C, so nothing is said of it."""
        share_told_signals(self.process, {signal.SIGINT})
        self.process.interrupt()
        self.process.wait(2.0)
