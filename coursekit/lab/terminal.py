"""A terminal in the notebook: one process, its output, its state, a Ctrl-C button and an input line."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import traitlets

from coursekit.processes.base_process import BaseProcess

from .bundle import with_text
from .docking import View
from .errors import NotNow
from .script import script, style
from .waiting import PATIENCE_SECONDS, until_said

LINES = 500
"""How many lines the browser keeps; the process keeps more."""
UPDATE_SECONDS = 0.1
"""The minimum period between outputs sent [s], so that a node that logs at 100 Hz does not flood the notebook."""


class Terminal(View):
    """The panel of one process.

    The process's output goes here, never into a cell. `text` is that output; `tail` returns its last lines.
    """

    _esm = script("terminal.js")
    _css = style("terminal.css")
    title = traitlets.Unicode("").tag(sync=True)

    def __init__(self, process: BaseProcess, title: str = "", again: Callable[[], Any] | None = None) -> None:
        super().__init__(title=title or process.name)
        self._again = again
        self._pending: list[str] = []
        self._lock = threading.Lock()
        self._alarm: Any = None
        self._seen = False
        self.on_msg(self._hear)
        self._follow(process)

    def _follow(self, process: BaseProcess) -> None:
        self.process = process
        process.on_output(lambda _stream, text: self._collect(text) if process is self.process else None)
        process.on_exit(lambda _: self._flush() if process is self.process else None)

    # -- for programs

    @property
    def text(self) -> str:
        """The output of the process (its newest two million characters)."""
        return str(self.process.output)

    def tail(self, lines: int = 10) -> str:
        """Return the last lines of the output."""
        return "\n".join(self.text.splitlines()[-lines:])

    def interrupt(self) -> None:
        """Press Ctrl-C."""
        self.process.interrupt()

    def type(self, line: str) -> None:
        """Type a line and press Enter."""
        self.process.write_stdin(line + "\n")

    def wait(self, timeout_sec: float | None = None, until: str = "") -> int | None:
        """Wait until the process ends, or has printed `until`. Returns its exit code, None while it runs."""
        if not until:
            return self.process.wait(timeout_sec)
        until_said(self.process, until, most=PATIENCE_SECONDS if timeout_sec is None else timeout_sec)
        code: int | None = self.process.exit_code
        return code

    def restart(self) -> None:
        """Run the same command line again in this terminal; a running process is ended first."""
        if self._again is None:
            raise NotNow("This terminal was made for a process that was started elsewhere; start that again.")
        if self.process.exit_code is None:
            self.process.interrupt()
            if self.process.wait(2.0) is None:
                self.process.kill()
                self.process.wait(2.0)
        self._follow(self._again())
        self._show_all()

    @property
    def state(self) -> str:
        """'running', or how the process ended."""
        if self.process.exit_code is None:
            return "running"
        return "finished" if self.process.exit_code == 0 else f"exit code {self.process.exit_code}"

    def __repr__(self) -> str:
        return f"[{self.title}: {self.state}]"

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_text(super()._repr_mimebundle_(**kwargs), repr(self))

    # -- to the browser

    def _collect(self, text: str) -> None:
        if not self._seen:
            return
        with self._lock:
            self._pending.append(text)
            if self._alarm is not None:
                return
            clock = self.process.session.clock
            self._alarm = clock.call_at(clock.steady() + round(UPDATE_SECONDS * 1e9), self._flush)

    def _flush(self) -> None:
        with self._lock:
            text, self._pending, self._alarm = "".join(self._pending), [], None
        if self._seen:
            self._tell(text)

    def _show_all(self) -> None:
        with self._lock:
            self._pending = []  # it is included in the whole text
            text = self.text
        self._tell(text, whole=True)

    def _tell(self, text: str, whole: bool = False) -> None:
        lines = text.splitlines(keepends=True)
        skipped = max(0, len(lines) - LINES)
        self.send(
            {
                "text": "".join(lines[skipped:]),
                "skipped": skipped,
                "whole": whole,
                "state": self.state,
                "command": " ".join(self.process.argv),
                "again": self._again is not None,
            }
        )

    def _hear(self, _widget: object, message: dict[str, Any], _buffers: object) -> None:
        kind = message.get("type")
        if kind == "ready":
            self._seen = True
            self._show_all()
        elif kind == "interrupt":
            self.process.interrupt()
        elif kind == "again" and self.process.exit_code is not None:
            self.restart()
        elif kind == "line":
            self.process.write_stdin(str(message.get("text", "")) + "\n")


class Terminals:
    """Terminals side by side, as Terminator shows them."""

    def __init__(self, terminals: list[Terminal], columns: int = 2) -> None:
        self.terminals = terminals
        self.columns = columns

    def __repr__(self) -> str:
        return " ".join(repr(terminal) for terminal in self.terminals)

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        import ipywidgets

        grid = ipywidgets.GridBox(
            self.terminals,
            layout=ipywidgets.Layout(grid_template_columns=f"repeat({self.columns}, minmax(0, 1fr))", grid_gap="8px"),
        )
        return with_text(grid._repr_mimebundle_(**kwargs), repr(self))
