"""Waiting for just-started programs before the graph is read.

On a robot, a command takes so long to start and to discover others that they are ready by then; here it would be
faster.
"""

from __future__ import annotations

from typing import Any

from coursekit.processes.process import Process, current_process
from coursekit.processes.session import Session, current

YOUTH_SECONDS = 2.0
"""The age after which a program without a node is not waited for [s]."""
CHILDHOOD_SECONDS = 0.5
"""The age at which a program with a node counts as ready, even if the node has no servers or subscriptions [s]."""
_LOOK_SECONDS = 0.01


def let_settle() -> None:
    """Wait until just-started programs have a node that is spun, or have ended. Wall clock only."""
    session = current()
    while not session.clock.virtual and any(_is_starting(session, process) for process in list(session.processes)):
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
