"""Waiting, before the graph is looked at, for programs that have just been started.

On a robot a command takes so long to start and to discover the others that they are there; here it would be faster.
"""

from __future__ import annotations

from typing import Any

from coursekit.processes.process import Process, current_process
from coursekit.processes.session import Session, current

YOUTH_SECONDS = 2.0
"""A program that has no node by then has none, or takes its time: nobody waits for it."""
CHILDHOOD_SECONDS = 0.5
"""A program that has a node is there by then, also if the node serves and hears nothing."""
_LOOK_SECONDS = 0.01


def let_settle() -> None:
    """Wait until programs that were started a moment ago have a node that is spun, or have ended. Wall clock only."""
    session = current()
    while not session.clock.virtual and any(_is_starting(session, one) for one in list(session.processes)):
        session.clock.sleep(_LOOK_SECONDS)


def _is_starting(session: Session, process: Any) -> bool:
    if not isinstance(process, Process) or process.name == "ros2" or process is current_process():
        return False
    age = (session.clock.steady() - process.started) * 1e-9
    if age >= YOUTH_SECONDS or process.exit_code is not None:
        return False
    nodes = [node for graph in list(session.graphs.values()) for node in list(graph.nodes) if node.process is process]
    spun = any(end.sink is not None for node in nodes for end in [*node.servers, *node.subscriptions])
    return not (spun or (nodes and age >= CHILDHOOD_SECONDS))
