"""`%ros2` and `%colcon`: the commands that a terminal has, in a cell."""

from __future__ import annotations

import os
import shlex
import sys
from pathlib import Path
from typing import Any

from IPython.core.magic import Magics, line_magic, magics_class

from coursekit.core.executables import ChildProcess
from coursekit.core.session import current

from .terminal import Terminal, Terminals

_terminals: dict[str, Terminal] = {}


def terminal(name: str) -> Terminal:
    """The newest terminal of that name: of the executable, the launch file, or what `--name` gave it."""
    try:
        return _terminals[name]
    except KeyError:
        known = ", ".join(_terminals) or "none yet; start one with `%ros2 run PACKAGE EXECUTABLE &`"
        raise LookupError(f"There is no terminal '{name}'. There are: {known}") from None


def terminals(*names: str, columns: int = 2) -> Terminals:
    """Terminals side by side; all of them when no name is given."""
    return Terminals([terminal(name) for name in names] or list(_terminals.values()), columns)


def wait(seconds: float) -> None:
    """Let the session run: the processes work on, this cell waits."""
    current().clock.sleep(seconds)


@magics_class
class CourseMagics(Magics):
    """The magics of the course."""

    @line_magic
    def ros2(self, line: str) -> Terminal | None:
        """Run a `ros2` command; with `&` at the end it goes on in a terminal of its own.

        %ros2 topic list
        %ros2 run demo_nodes_py talker &
        %ros2 --stop-after 3 topic echo /chatter
        """
        from coursekit.cli.parser import run

        options, argv, background = _read(self._expanded(line))
        env = workspace_environment(options.pop("workspace", None))
        process = current().start(lambda: run(argv), name="ros2", argv=argv, env=env, on_output=_to_cell(background))
        return _attend(process, options.get("name") or _title(argv), options.get("stop-after"), background)

    @line_magic
    def colcon(self, line: str) -> Terminal | None:
        """Run colcon, in the folder of `--workspace` or the current one."""
        options, argv, background = _read(self._expanded(line))
        folder = Path(options.pop("workspace", None) or os.environ.get("COURSEKIT_WORKSPACE", "."))
        command = [sys.executable, "-m", "colcon", *argv]
        process = ChildProcess(
            current(), command, name="colcon", cwd=folder, env=dict(os.environ) | {"PYTHONUNBUFFERED": "1"}
        )
        current().launch(process, _to_cell(background))
        return _attend(process, options.get("name") or "colcon", options.get("stop-after"), background)

    def _expanded(self, line: str) -> str:
        return str(self.shell.var_expand(line)) if "{" not in line else line


def _read(line: str) -> tuple[dict[str, str], list[str], bool]:
    """Our own options (before the command), the command, and whether it ends with `&`."""
    words = shlex.split(line)
    background = bool(words) and words[-1] == "&"
    words = words[:-1] if background else words
    options: dict[str, str] = {}
    while words and words[0] in ("--name", "--stop-after", "--workspace"):
        options[words[0][2:]] = words[1]
        words = words[2:]
    return options, words, background


def _title(argv: list[str]) -> str:
    """What a terminal is called: for `run` and `launch` the last name, else the command."""
    if argv[:1] in (["run"], ["launch"]) and len(argv) > 2:
        return argv[2]
    return " ".join(argv[:3])


def _to_cell(background: bool) -> Any:
    """Where output goes: into the cell that waits for it, or only into the terminal."""
    if background:
        return None
    return lambda stream, text: print(text, end="", flush=True)


def _attend(process: Any, title: str, stop_after: str | None, background: bool) -> Terminal | None:
    if background:
        shown = Terminal(process, title)
        _terminals[title] = shown
        return shown
    try:
        if process.wait(float(stop_after) if stop_after else None) is None:
            _end(process)
    except KeyboardInterrupt:
        _end(process)
    return None


def _end(process: Any) -> None:
    """Press Ctrl-C, and more if that does not help."""
    process.interrupt()
    if process.wait(5.0) is None:
        print(f"{process.name} ignores Ctrl-C; it was terminated.")
        process.kill()
        process.wait(2.0)


def workspace_environment(workspace: str | None = None) -> dict[str, str]:
    """The environment after `source install/setup.bash` of the workspace, if it has been built."""
    env = dict(os.environ)
    root = Path(workspace or env.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()
    install = root / "install"
    if install.is_dir():
        from coursekit.packages.overlay import overlay_environment

        env = overlay_environment(install, env)
    return env


__all__ = ["CourseMagics", "terminal", "terminals", "wait"]
