"""`%%commands`: a table of commands, each with a button that runs it."""

from __future__ import annotations

import html
import os
import shutil
import sysconfig
from dataclasses import dataclass
from typing import Any

import ipywidgets
from IPython.core.magic import Magics, cell_magic, magics_class

from coursekit.processes.child import ChildProcess
from coursekit.processes.session import current
from coursekit.systems.command_lines import split_words
from coursekit.systems.shell_spelling import line_here
from coursekit.words.gettext import gettext

from .bundle import with_text
from .cells import give_to, this_cell
from .errors import BadArgument, NotThere
from .magics import CourseMagics, workspace, workspace_environment
from .terminal import Terminal

SHELL_ONLY = ("source", "export", "cd", "echo", "rm")
"""Commands that only a shell has, or that change its state: their rows can only be typed in a terminal."""


@dataclass(frozen=True)
class Row:
    """A command as it is typed in a terminal, and what it does."""

    command: str
    meaning: str

    @property
    def runs(self) -> bool:
        """Whether the row can be run from the notebook."""
        return self.command.split()[0] not in SHELL_ONLY


def read_rows(text: str) -> list[Row]:
    """Parse lines of the form `COMMAND | WHAT IT DOES`; ValueError for any other line.

    >>> read_rows("ros2 node list | all nodes")
    [Row(command='ros2 node list', meaning='all nodes')]
    """
    rows = []
    for number, line in enumerate(text.splitlines(), 1):
        command, bar, meaning = (part.strip() for part in line.rpartition(" | "))
        if line.strip() and not (bar and command and meaning):
            raise BadArgument(f"line {number} of %%commands is no row: {line!r}. Write: ros2 node list | all nodes")
        if line.strip():
            rows.append(Row(command, meaning))
    return rows


def start(command: str, magics: CourseMagics) -> Terminal:
    """Start a command line in its own terminal; LookupError when there is no such program."""
    words = split_words(command)
    if words[:1] in (["ros2"], ["colcon"]):
        shown = getattr(magics, words[0])(command.split(None, 1)[1] + " &" if len(words) > 1 else "-h &")
        assert isinstance(shown, Terminal)
        return shown
    env = workspace_environment()
    path = os.pathsep.join((sysconfig.get_path("scripts"), env.get("PATH", "")))
    program = shutil.which(words[0], path=path) if words else None
    if program is None:
        raise NotThere(f"There is no program '{words[0] if words else ''}'. Rows begin with ros2, colcon or coursekit.")

    def begin() -> Any:
        child = ChildProcess(current(), [program, *words[1:]], name=words[0], env=env, cwd=workspace(), one_stream=True)
        return current().launch(child, None)

    return Terminal(begin(), command, again=begin)


class CommandRow(ipywidgets.VBox):  # type: ignore[misc]
    """An editable command line with a run button, and its terminal below."""

    def __init__(self, row: Row, magics: CourseMagics) -> None:
        self.row = row
        self._magics = magics
        self._cell = this_cell()
        self.terminal: Terminal | None = None
        self.line = ipywidgets.Text(value=line_here(row.command), layout=ipywidgets.Layout(flex="0 0 50%", width="auto"))
        self.button = ipywidgets.Button(
            icon="play",
            disabled=not row.runs,
            tooltip=gettext("run it") if row.runs else gettext("for a terminal: it changes the shell"),
            layout=ipywidgets.Layout(flex="0 0 36px", width="auto"),
        )
        self.button.on_click(self._run)
        self._head = ipywidgets.HBox([self.button, self.line, _wrapped(row.meaning)])
        super().__init__([self._head])

    def _run(self, _button: object) -> None:
        if self.terminal is not None and self.terminal.process.exit_code is None:
            self.terminal.interrupt()
        try:
            self.terminal = start(self.line.value, self._magics)
        except (LookupError, ValueError) as error:
            self._below(ipywidgets.Label(gettext(str(error))))
            return
        give_to(self._cell, self.terminal.process)
        self._below(self.terminal)

    def _below(self, widget: object) -> None:
        self.children = (self._head, widget)


def _wrapped(text: str) -> Any:
    """Return a text that wraps beside its row: a Label would be cut off at the page's edge."""
    layout = ipywidgets.Layout(flex="1 1 0", width="auto", min_width="0")
    return ipywidgets.HTML(f"<div style='line-height: 1.4; padding: 5px 4px'>{html.escape(text)}</div>", layout=layout)


class CommandTable(ipywidgets.VBox):  # type: ignore[misc]
    """A column of `CommandRow`; its `repr` is a text table."""

    def __init__(self, rows: list[Row], magics: CourseMagics) -> None:
        self.rows = [CommandRow(row, magics) for row in rows]
        super().__init__(self.rows)

    def __repr__(self) -> str:
        width = max((len(row.row.command) for row in self.rows), default=0)
        return "\n".join(f"{row.row.command:{width}}  {row.row.meaning}" for row in self.rows)

    def _repr_mimebundle_(self, **kwargs: Any) -> Any:
        return with_text(super()._repr_mimebundle_(**kwargs), repr(self))


@magics_class
class CommandMagics(Magics):
    """`%%commands`."""

    @cell_magic
    def commands(self, _line: str, cell: str) -> CommandTable:
        """Show a table of lines `COMMAND | WHAT IT DOES`; each row has a run button, and its command can be edited.

        %%commands
        ros2 node list | all nodes
        """
        return CommandTable(read_rows(cell), CourseMagics(self.shell))


__all__ = ["CommandMagics", "CommandTable", "Row", "read_rows", "start"]
