"""A component that was loaded: the process that runs it and the node that came with it."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Any

import yaml
from composition_interfaces.srv import LoadNode
from rclpy.parameter import Parameter

from coursekit.core.session import current
from coursekit.nodes.running import pass_on_output

PATIENCE = 10.0  # seconds until a component has its node
_LEVELS = {10: "debug", 20: "info", 30: "warn", 40: "error", 50: "fatal"}


def arguments_of(request: LoadNode.Request) -> list[str]:
    """What the component's program gets on its command line.

    >>> arguments_of(LoadNode.Request(node_name="tom", remap_rules=["chatter:=chat"]))
    ['--ros-args', '-r', '__node:=tom', '-r', 'chatter:=chat']
    """
    rules = [f"__node:={request.node_name}"] if request.node_name else []
    rules += [f"__ns:={request.node_namespace}"] if request.node_namespace else []
    words = ["--ros-args"]
    for rule in [*rules, *request.remap_rules]:
        words += ["-r", rule]
    for parameter in request.parameters:
        value = yaml.safe_dump(Parameter.from_parameter_msg(parameter).value, default_flow_style=True, width=10**9)
        words += ["-p", f"{parameter.name}:={value.removesuffix(chr(10)).removesuffix('...').strip()}"]
    if request.log_level in _LEVELS:
        words += ["--log-level", _LEVELS[request.log_level]]
    return words


class LoadedComponent:
    """Starts a component's program, whose output becomes the container's.

    Raises RuntimeError when it ends, or has no node after ten seconds.
    """

    def __init__(self, path: Path, request: LoadNode.Request, graph: Any) -> None:
        self._process = current().start_executable(path, arguments_of(request), on_output=pass_on_output())
        self.full_name = self._wait_for_node(graph)

    def _wait_for_node(self, graph: Any) -> str:
        for _ in range(round(PATIENCE / 0.01)):
            names = [node.full_name for node in list(graph.nodes) if node.process is self._process]
            if names:
                return str(names[0])
            if self._process.exit_code is not None:
                raise RuntimeError(f"Component constructor threw an exception: it ended with {self._process.exit_code}")
            time.sleep(0.01)
        self.unload()
        raise RuntimeError(f"Component has no node after {PATIENCE:.0f} s")

    def unload(self) -> None:
        """End the program, as Ctrl-C does."""
        self._process.interrupt()
        self._process.wait(2.0)
