"""The session inside a Jupyter kernel: its start, its end, and its server for terminals."""

from __future__ import annotations

import atexit
import contextlib
import os
import sys
import time
import warnings
from typing import Any

import ipywidgets

from coursekit.cli.session_client import domain_id
from coursekit.cli.session_server import serve
from coursekit.grade import answer_age
from coursekit.jupyter.kernel import hear_all, keep_output_in_cells
from coursekit.packages.environment import source_underlay
from coursekit.processes.session import NETWORK_VARIABLE, Session, current
from coursekit.view.shell import running_shell
from coursekit.words.gettext import gettext

from . import error_advice, help_text, interrupted, missing_names, shell_lines
from .cells import Cells
from .command_table import CommandMagics
from .magics import CourseMagics
from .network import NetworkMagics
from .panel import end_panels

SUBSHELL_SECONDS = 0.5
"""The timeout for the page to create a subshell; without one by then there is no page, or it is busy [s]."""
NO_FOLDERS_KEPT = "This is now an optional IPython functionality"
"""The warning of IPython 8 (the last for Python 3.10) at every %cd: folders are not remembered for the next kernel."""
_state: dict[str, Any] = {}


def start() -> Session:
    """Create this kernel's session; further calls return the same session."""
    session = current()
    if _state.get("session") is session:
        return session
    _state["session"] = session
    source_underlay(os.environ)
    os.environ.setdefault("COURSEKIT_COURSE", os.path.abspath("."))  # set once: a cell may change the folder
    os.environ.setdefault("COURSEKIT_WORKSPACE", os.path.abspath("ros2_ws"))
    with contextlib.suppress(OSError):  # a read-only folder can still be viewed; writing raises the error
        os.makedirs(os.environ["COURSEKIT_WORKSPACE"], exist_ok=True)
    session.open()
    shell = running_shell()
    if shell is not None and getattr(shell, "kernel", None) is not None:
        session.embedded = True
        warnings.filterwarnings("ignore", message=NO_FOLDERS_KEPT)
        hear_all(shell.kernel)
        keep_output_in_cells(shell)
        cells = Cells(session, shell, lambda: _begin_cell(session, shell.kernel))
        shell.register_magics(CourseMagics, CommandMagics, NetworkMagics)
        shell_lines.install(shell)
        missing_names.install(shell)
        error_advice.install(shell)
        interrupted.install(shell)
        answer_age.install(shell)
        help_text.install(shell)
        if cells.in_cell:
            _have_a_subshell(session, shell.kernel)
    if not session.clock.virtual:
        _serve_terminals(session)
    if os.environ.get(NETWORK_VARIABLE):
        session.meet(domain_id())
    atexit.register(_stop)
    return session


def _have_a_subshell(session: Session, kernel: Any) -> None:
    """Show JupyterLab a widget now: at the first widget it creates the subshell that serves panels while a cell runs."""
    if session.clock.virtual or "first widget" in _state:
        return
    _state["first widget"] = ipywidgets.Layout()
    thread = getattr(kernel, "shell_channel_thread", None)
    give_up = time.monotonic() + SUBSHELL_SECONDS
    while thread is not None and not thread.manager.list_subshell() and time.monotonic() < give_up:
        time.sleep(0.02)


def _begin_cell(session: Session, kernel: Any) -> None:
    _claim_terminals()
    _have_a_subshell(session, kernel)


def _serve_terminals(session: Session) -> None:
    """Serve the terminals of the domain: the notebook opened last owns them, until a cell of another notebook runs."""
    _state["server"] = serve(session, domain_id(), notebook_name(), take=True)
    if _state["server"] is None:
        print(gettext("Terminals cannot reach this notebook. What is wrong, and the cure: !coursekit doctor"))


def notebook_name() -> str:
    """Return the file name of this kernel's notebook, if Jupyter or VS Code reports it."""
    path = os.environ.get("JPY_SESSION_NAME") or running_variables().get("__vsc_ipynb_file__") or "a notebook"
    return os.path.basename(str(path))


def running_variables() -> dict[str, Any]:
    """Return the variables of the notebook; empty outside of a notebook."""
    return dict(getattr(running_shell(), "user_ns", {}))


def _claim_terminals() -> None:
    server = _state.get("server")
    if server is not None:
        with contextlib.suppress(OSError):
            server.claim()


def _stop() -> None:
    server = _state.pop("server", None)
    if server is not None:
        server.close()
    session = _state.pop("session", None)
    if session is not None:
        session.close(grace_sec=0.5)


def reset() -> None:
    """End every process and node of the session, as after a kernel restart; variables stay.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> reset()
    Reset: 1 process ended. The graph is empty.
    """
    session = start()
    _claim_terminals()
    ended = _started(session)
    for process in list(session.processes):
        process.interrupt()
    for process in list(session.processes):
        if process.wait(1.0) is None:
            process.kill()
            process.wait(2.0)
    end_panels(gettext("It ended with reset()."))
    left = leave_network(session)
    nodes = sum(len(graph.nodes) for graph in session.graphs.values())
    for graph in session.graphs.values():
        graph.clear()
    _forget_interpreter_contexts(session)
    print(_farewell(ended, nodes))
    if left:
        print(gettext("The network was left. To join it again: %network ADDRESS"))


def _started(session: Session) -> int:
    """Count the processes, a `ros2 run` and the program that it runs as one: the user has started one thing."""
    parents = [process.parent for process in session.processes]
    passing_on = [process for process in parents if process is not None and process.argv[:2] == ["ros2", "run"]]
    return len(session.processes) - len({process.pid for process in passing_on})


def _farewell(processes: int, nodes: int) -> str:
    """Describe what a reset has ended.

    >>> _farewell(0, 0)
    'Reset: nothing was running. The graph is empty.'
    >>> _farewell(2, 1)
    'Reset: 2 processes and 1 node ended. The graph is empty.'
    """
    counts = []
    if processes:
        counts.append(gettext("1 process") if processes == 1 else gettext(f"{processes} processes"))
    if nodes:
        counts.append(gettext("1 node") if nodes == 1 else gettext(f"{nodes} nodes"))
    if not counts:
        return gettext("Reset: nothing was running. The graph is empty.")
    return gettext(f"Reset: {gettext(' and ').join(counts)} ended. The graph is empty.")


def leave_network(session: Session) -> bool:
    """Leave the network, if one was joined."""
    joining = sys.modules.get("coursekit.net.joining")  # not imported means never joined
    return joining is not None and bool(joining.leave(session))


def _forget_interpreter_contexts(session: Session) -> None:
    from rclpy.context import shutdown_all

    shutdown_all()
    session.locals.clear()


__all__ = ["reset", "start"]
