"""The session inside a Jupyter kernel: its start, its server for terminals, and what belongs to which cell."""

from __future__ import annotations

import atexit
import contextlib
import os
import sys
import time
from collections import Counter
from typing import Any

import ipywidgets

from coursekit.jupyter.kernel import hear_all, keep_output_in_cells
from coursekit.packages.environment import source_underlay
from coursekit.processes.session import Session, current

from . import shell_lines
from .panel import Panel, end_panels, open_panels

SUBSHELL_SECONDS = 0.5
"""A page that makes no subshell in this time is none, or is busy [s]."""
_state: dict[str, Any] = {}


def running_shell() -> Any:
    """The IPython shell, None outside of one."""
    ipython = sys.modules.get("IPython")
    return ipython.get_ipython() if ipython is not None else None


def start() -> Session:
    """Make this kernel's session: once; further calls give the same one."""
    session = current()
    if _state.get("session") is session:
        return session
    _state["session"] = session
    source_underlay(os.environ)
    os.environ.setdefault("COURSEKIT_COURSE", os.path.abspath("."))  # said once: a cell may change the folder
    os.environ.setdefault("COURSEKIT_WORKSPACE", os.path.abspath("ros2_ws"))
    with contextlib.suppress(OSError):  # a folder that can only be read may still be looked at; writing says what is wrong
        os.makedirs(os.environ["COURSEKIT_WORKSPACE"], exist_ok=True)
    session.open()
    shell = running_shell()
    if shell is not None and getattr(shell, "kernel", None) is not None:
        session.embedded = True
        hear_all(shell.kernel)
        keep_output_in_cells(shell)
        cells = Cells(session, shell)
        _state["cells"] = cells
        _register_magics(shell)
        shell_lines.install(shell)
        if cells.in_cell:
            _have_a_subshell(session, shell.kernel)
    if not session.clock.virtual:
        _serve_terminals(session)
    atexit.register(_stop)
    return session


def _have_a_subshell(session: Session, kernel: Any) -> None:
    """Show JupyterLab a widget now: with the first it makes the subshell that answers panels while a cell runs."""
    if session.clock.virtual or "first widget" in _state:
        return
    _state["first widget"] = ipywidgets.Layout()
    thread = getattr(kernel, "shell_channel_thread", None)
    give_up = time.monotonic() + SUBSHELL_SECONDS
    while thread is not None and not thread.manager.list_subshell() and time.monotonic() < give_up:
        time.sleep(0.02)


def _register_magics(shell: Any) -> None:
    from .command_table import CommandMagics
    from .magics import CourseMagics

    shell.register_magics(CourseMagics, CommandMagics)


def _serve_terminals(session: Session) -> None:
    """Have the terminals of the domain: the notebook that is opened last has them, until a cell of another is run."""
    from coursekit.cli.attach import domain_id
    from coursekit.cli.session_server import serve

    _state["server"] = serve(session, domain_id(), notebook_name(), take=True)
    if _state["server"] is None:
        print("Terminals cannot reach this notebook. What is wrong, and the cure: !coursekit doctor")


def notebook_name() -> str:
    """The file of this kernel's notebook, as far as Jupyter or VS Code tells it."""
    path = os.environ.get("JPY_SESSION_NAME") or running_variables().get("__vsc_ipynb_file__") or "a notebook"
    return os.path.basename(str(path))


def running_variables() -> dict[str, Any]:
    """The variables of the notebook; none outside of one."""
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
    """End every process and node of the session, as if the kernel had been restarted; variables stay."""
    session = start()
    _claim_terminals()
    ended = len(session.processes)
    for process in list(session.processes):
        process.interrupt()
    for process in list(session.processes):
        if process.wait(1.0) is None:
            process.kill()
            process.wait(2.0)
    end_panels("It ended with reset().")
    nodes = sum(len(graph.nodes) for graph in session.graphs.values())
    for graph in session.graphs.values():
        graph.clear()
    _forget_interpreter_contexts(session)
    print(f"Reset: {ended} processes and {nodes} nodes ended. The graph is empty.")


def _forget_interpreter_contexts(session: Session) -> None:
    from rclpy.context import shutdown_all

    shutdown_all()
    session.locals.clear()


class Cells:
    """Knows which processes and nodes each cell made, so that running it again replaces them."""

    def __init__(self, session: Session, shell: Any) -> None:
        self.session = session
        self.cell = ""
        self.made: dict[str, list[Any]] = {}
        self.ran: dict[str, str] = {}
        """The text of each cell as it was run last."""
        self.counts: Counter[str] = Counter()
        """How often the running cell has done what."""
        self.shell = shell
        session.on_start.append(self._note_process)
        shell.events.register("pre_run_cell", self._begin)
        shell.events.register("post_run_cell", self._end)
        session.in_cell = bool(shell.kernel.get_parent())  # the one that imports the lab, or the kernel starts with it

    @property
    def in_cell(self) -> bool:
        """Whether a cell runs now."""
        return bool(self.session.in_cell)

    def _note_process(self, process: Any) -> None:
        if process.parent is None and self.session.in_cell and self.cell:
            self.made.setdefault(self.cell, []).append(process)

    def _note_nodes(self) -> None:
        nodes = [node for graph in self.session.graphs.values() for node in graph.nodes if node.process is None]
        seen = [node for node in nodes if not node.name.startswith("_")]  # hidden ones belong to panels
        for one in [*seen, *(panel for panel in open_panels() if panel.of_cell)]:
            if not any(one is known for made in self.made.values() for known in made):
                self.made.setdefault(self.cell, []).append(one)

    def _begin(self, info: Any) -> None:
        self.cell = getattr(info, "cell_id", None) or ""
        self.counts.clear()
        if self.cell:
            self.ran.pop(self.cell, None)  # the cell that runs comes last
            self.ran[self.cell] = str(getattr(info, "raw_cell", "") or "")
        replaced = [_describe(one) for one in self.made.pop(self.cell, []) if _end_one(one)]
        if replaced:
            print(f"Run again: replaced {', '.join(dict.fromkeys(replaced))}.")
        self.session.in_cell = True
        _claim_terminals()
        _have_a_subshell(self.session, self.shell.kernel)

    def _end(self, _result: Any) -> None:
        if self.cell:
            self._note_nodes()
        self.session.in_cell = False


def last_runs() -> dict[str, str]:
    """The text of each cell as it was run last, by the cell's id."""
    cells = _state.get("cells")
    return dict(cells.ran) if cells is not None else {}


def adopt(old: Any, new: Any) -> Any:
    """Let `new` belong to the cell that made `old`: it was started again, not by a cell. Returns `new`."""
    cells = _state.get("cells")
    for made in cells.made.values() if cells is not None else ():
        if old in made:
            made[made.index(old)] = new
    return new


def this_cell() -> str:
    """The id of the cell that runs now or ran last; '' outside of a kernel."""
    cells = _state.get("cells")
    return cells.cell if cells is not None else ""


def run_number(what: str) -> int:
    """Which time it is that the running cell does this: 0, then 1, ..."""
    cells = _state.get("cells")
    if cells is None:
        return 0
    cells.counts[what] += 1
    return int(cells.counts[what]) - 1


def give_to(cell: str, process: Any) -> None:
    """Let a process belong to a cell: it was started by what the cell shows."""
    cells = _state.get("cells")
    if cells is not None and cell:
        cells.made.setdefault(cell, []).append(process)


def _describe(one: Any) -> str:
    return f"node {one.full_name}" if hasattr(one, "full_name") else f"process {' '.join(one.argv)}"


def _end_one(one: Any) -> bool:
    """End a process, node or panel of an earlier run; whether it is worth a word that it was still there."""
    if isinstance(one, Panel):
        one.close()
        return False
    if hasattr(one, "full_name"):
        there = one in one.graph.nodes
        one.close()
        return there
    if one.exit_code is not None:
        return False
    one.interrupt()
    if one.wait(1.0) is None:
        one.kill()
        one.wait(2.0)
    return True


__all__ = ["adopt", "give_to", "last_runs", "reset", "run_number", "start", "this_cell"]
