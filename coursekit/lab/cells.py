"""Track the objects made by each notebook cell: running a cell again replaces the objects that it made before."""

from __future__ import annotations

import sys
from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

from IPython.core.interactiveshell import ExecutionInfo, ExecutionResult

from coursekit.processes.base_process import BaseProcess
from coursekit.processes.session import Session
from coursekit.words.gettext import gettext

from .panel import Panel, open_panels

if TYPE_CHECKING:
    from ipykernel.zmqshell import ZMQInteractiveShell

T = TypeVar("T")

_running: dict[str, Cells] = {}
"""The `Cells` of this kernel, under the key 'cells'; empty outside of a kernel."""


class Cells:
    """Tracks which processes and nodes each cell made, so that running the cell again replaces them."""

    def __init__(self, session: Session, shell: ZMQInteractiveShell, on_begin: Callable[[], None]) -> None:
        self.session = session
        self.on_begin = on_begin
        """Called when a cell begins."""
        self.cell = ""
        self.made: dict[str, list[Any]] = {}
        self.ran: dict[str, str] = {}
        """The text of each cell at its last run."""
        self.counts: Counter[str] = Counter()
        """How often the running cell has done each thing; see `run_number`."""
        session.on_start.append(self._note_process)
        shell.events.register("pre_run_cell", self._begin)
        shell.events.register("post_run_cell", self._end)
        session.in_cell = bool(shell.kernel.get_parent())  # true if a cell imports the lab, not the kernel
        _running["cells"] = self

    @property
    def in_cell(self) -> bool:
        """Whether a cell is running."""
        return bool(self.session.in_cell)

    def _note_process(self, process: BaseProcess) -> None:
        if process.parent is None and self.session.in_cell and self.cell:
            self.made.setdefault(self.cell, []).append(process)

    def _note_nodes(self) -> None:
        nodes = [node for graph in self.session.graphs.values() for node in graph.nodes if node.process is None]
        seen = [node for node in nodes if not node.name.startswith("_")]  # hidden nodes belong to panels
        for new in [*seen, *(panel for panel in open_panels() if panel.of_cell), *_contexts()]:
            if not any(new is known for things in self.made.values() for known in things):
                self.made.setdefault(self.cell, []).append(new)

    def _begin(self, info: ExecutionInfo) -> None:
        self.cell = getattr(info, "cell_id", None) or ""
        self.counts.clear()
        if self.cell:
            self.ran.pop(self.cell, None)  # the running cell moves to the end
            self.ran[self.cell] = str(getattr(info, "raw_cell", "") or "")
        replaced = [thing for thing in self.made.pop(self.cell, []) if _end_one(thing)]
        if replaced:
            print(gettext(f"Run again: replaced {_listed(replaced)}."))
        self.session.in_cell = True
        self.on_begin()

    def _end(self, _result: ExecutionResult) -> None:
        if self.cell:
            self._note_nodes()
        self.session.in_cell = False


def _contexts() -> list[Any]:
    """Return the contexts that `rclpy.init()` began in cells and that are not shut down."""
    module = sys.modules.get("rclpy.context")  # not imported means never used
    return list(module._contexts_here()) if module is not None else []


def last_runs() -> dict[str, str]:
    """Return the text of each cell at its last run, by cell id."""
    cells = _running.get("cells")
    return dict(cells.ran) if cells is not None else {}


def adopt(old: object, new: T) -> T:
    """Assign `new` to the cell that made `old`, after a restart that no cell caused. Returns `new`."""
    cells = _running.get("cells")
    for things in cells.made.values() if cells is not None else ():
        if old in things:
            things[things.index(old)] = new
    return new


def this_cell() -> str:
    """Return the id of the cell that is running or ran last; '' outside of a kernel."""
    cells = _running.get("cells")
    return cells.cell if cells is not None else ""


def run_number(what: str) -> int:
    """Return how often the running cell has done this before: 0, then 1, ..."""
    cells = _running.get("cells")
    if cells is None:
        return 0
    cells.counts[what] += 1
    return int(cells.counts[what]) - 1


def give_to(cell: str, process: BaseProcess) -> None:
    """Assign a process to a cell: something that the cell shows has started it."""
    cells = _running.get("cells")
    if cells is not None and cell:
        cells.made.setdefault(cell, []).append(process)


def _listed(things: list[Any]) -> str:
    """List what was replaced: first the processes, then the nodes, then the context, each with its kind once."""
    processes = dict.fromkeys(_typed(thing) for thing in things if hasattr(thing, "argv"))
    nodes = dict.fromkeys(thing.full_name for thing in things if hasattr(thing, "full_name"))
    parts = []
    if processes:
        said = _joined([f"`{line}`" for line in processes])
        parts.append(gettext(f"process {said}") if len(processes) == 1 else gettext(f"the processes {said}"))
    if nodes:
        parts.append(gettext(f"node {_joined(nodes)}") if len(nodes) == 1 else gettext(f"the nodes {_joined(nodes)}"))
    if any(hasattr(thing, "try_shutdown") for thing in things):
        parts.append("rclpy.init()")
    return _joined(parts)


def _joined(texts: Iterable[str]) -> str:
    """Join texts as a sentence does: a, b and c."""
    *first, last = texts
    return gettext(" and ").join([", ".join(first), last] if first else [last])


def _typed(process: BaseProcess) -> str:
    """Return the command line of a process, or its own name if that has an absolute path."""
    return str(process.name) if Path(process.argv[0]).is_absolute() else " ".join(process.argv)


def _end_one(thing: Any) -> bool:
    """End a process, node, context or panel of an earlier run. Returns whether the user should be notified."""
    if isinstance(thing, Panel):
        thing.close()
        return False
    if hasattr(thing, "full_name"):
        there = thing in thing.graph.nodes
        thing.close()
        return there
    if hasattr(thing, "try_shutdown"):
        there = bool(thing.ok())
        thing.try_shutdown()
        return there
    if thing.exit_code is not None:
        return False
    thing.interrupt()
    if thing.wait(1.0) is None:
        thing.kill()
        thing.wait(2.0)
    return True


__all__ = ["Cells", "adopt", "give_to", "last_runs", "run_number", "this_cell"]
