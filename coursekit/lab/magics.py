"""`%ros2` and `%colcon`: terminal commands in a cell."""

from __future__ import annotations

import contextvars
import os
import re
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

from IPython.core.magic import Magics, cell_magic, line_magic, magics_class, no_var_expand

from coursekit.processes.base_process import BaseProcess
from coursekit.processes.child import ChildProcess
from coursekit.processes.session import current
from coursekit.systems.command_lines import split_words
from coursekit.systems.letter_case import other_spelling
from coursekit.words.gettext import gettext

from .cells import adopt
from .errors import NotThere
from .known_terminals import KNOWN
from .magic_values import Values
from .terminal import Terminal, Terminals
from .waiting import until_said
from .written_parts import WrittenParts

_DURATION = re.compile(r"\[[0-9.]+(min )?[0-9.]*s(?=[],])")


def terminal(name: str) -> Terminal:
    """Return the newest terminal named after the executable, the launch file, or the value of `--name`.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> wait(2.5)
    >>> print(terminal("talker").tail(2))
    [INFO] [1700000001.000000000] [talker]: Publishing: "Hello World: 0"
    [INFO] [1700000002.000000000] [talker]: Publishing: "Hello World: 1"
    >>> terminal("talker").interrupt()
    """
    try:
        return KNOWN[name]
    except KeyError:
        known = ", ".join(KNOWN) or "none yet; start one with `%ros2 run PACKAGE EXECUTABLE &`"
        raise NotThere(f"There is no terminal '{name}'. There are: {known}") from None


def show_as(name: str, shown: Terminal) -> None:
    """Register a terminal under a name for `terminal(name)`."""
    KNOWN[name] = shown


def terminals(*names: str, columns: int = 2) -> Terminals:
    """Show terminals side by side; all of them when no name is given.

    >>> %ros2 run demo_nodes_py talker &
    [talker: running]
    >>> %ros2 run demo_nodes_py listener &
    [listener: running]
    >>> terminals("talker", "listener")
    [talker: running] [listener: running]
    """
    return Terminals([terminal(name) for name in names] or list(KNOWN.values()), columns)


def edit(path: str, old: str, new: str) -> None:
    """Replace `old` by `new` in a file of the workspace and show the new lines.

    It can be run again at any time. An existing addition is not added twice, and a cell with a changed edit replaces
    its own earlier edit. LookupError when the file or the text is missing.

    >>> %%write src/greeting.py
    ... who = "robot"
    ... print("hello", who)
    Wrote ros2_ws/src/greeting.py (2 lines)
    >>> edit("src/greeting.py", 'print("hello", who)', 'print("good morning", who)')
    src/greeting.py:
        print("good morning", who)
    """
    file = workspace() / path
    if not file.is_file():
        raise NotThere(f"There is no {path} in {workspace().name}/. Is the name right, was the cell above run?")
    if WrittenParts(file).edit(old, new):
        print(f"{path}:", *(f"    {line}" for line in new.splitlines()), sep="\n")
    else:
        print(gettext(f"{path}: this edit was made before, and the lines were changed since. They stay as they are."))


@magics_class
class CourseMagics(Magics):
    """The magics of the course."""

    @no_var_expand
    @line_magic
    def ros2(self, line: str) -> Terminal | None:
        """Run a `ros2` command; with `&` at the end it runs on in its own terminal.

        %ros2 topic list
        %ros2 run demo_nodes_py talker &
        %ros2 --stop-after 3 topic echo /chatter
        %ros2 --stop-after 3 --until "data:" topic echo /chatter  (longer, if there was no such output by then)
        """
        from coursekit.cli.parser import run

        options, argv, background = self._words(line)
        env = workspace_environment(options.pop("workspace", None))

        def begin() -> Any:
            sink = _to_cell(background)
            return current().start(lambda: run(argv), name="ros2", argv=argv, env=env, on_output=sink)

        return _attend(begin, options.get("name") or _title(argv), options, background)

    @no_var_expand
    @line_magic
    def colcon(self, line: str) -> Terminal | None:
        """Run colcon in the folder of `--workspace`, or in the current workspace."""
        options, argv, background = self._words(line)
        folder = Path(options.get("workspace") or workspace())
        folder.mkdir(parents=True, exist_ok=True)
        command = [sys.executable, "-m", "colcon", *argv]
        virtual = current().clock.virtual
        if virtual and argv[:1] == ["build"]:
            command += ["--executor", "sequential"]
        env = dict(os.environ) | {"PYTHONUNBUFFERED": "1"}
        env.pop("PYTHONDONTWRITEBYTECODE", None)  # setuptools would warn about it in every build

        def begin() -> Any:
            process = ChildProcess(current(), command, name="colcon", cwd=folder, env=env, takes_time=False, one_stream=True)
            return current().launch(process, _to_cell(background, _without_durations if virtual else str))

        return _attend(begin, options.get("name") or "colcon", options, background)

    @cell_magic
    def write(self, line: str, cell: str) -> None:
        """Write the cell to a file of the workspace: `%%write src/my_package/my_package/my_node.py`.

        `%%write -a FILE` appends it to the file. A cell that is run again replaces its own part.
        """
        name = line.strip()
        append = name.startswith("-a ")
        name = name.removeprefix("-a ").strip()
        other = other_spelling(workspace() / name)
        if other:
            right = (Path(name).parent / other).as_posix()
            same = f"Not written: {right} is there, and the same file on this computer. Type its name: %%write {right}"
            print(gettext(same))
            return
        written = WrittenParts(workspace() / name)
        total = len((written.append(cell) if append else written.write(cell)).splitlines())
        print(gettext(f"Wrote {workspace().name}/{name} ({total} lines)"))

    @no_var_expand
    @line_magic
    def cd(self, line: str) -> None:
        """Change the folder, as IPython's `%cd`, which refuses `{workspace()}` in a folder such as `Vera's course`."""
        shell, values = self.shell, Values()
        assert shell is not None  # it is what runs this
        expanded = values.expanded(shell, line)
        *options, folder = expanded.split() or [""]
        path = values.restored(folder)
        if path == folder:
            shell.magics_manager.registry["OSMagics"].cd(expanded)
            return
        os.chdir(path)
        shell.user_ns["_dh"].append(Path.cwd())  # for `%cd -`
        if "-q" not in options:
            print(path)

    @line_magic
    def show(self, line: str) -> None:
        """Print a file of the workspace, or list one of its folders: `%show src/my_package/setup.py`."""
        path = workspace() / line.strip()
        if path.is_dir():
            files = (file for file in sorted(path.rglob("*")) if file.is_file() and "__pycache__" not in file.parts)
            print("\n".join(file.relative_to(path).as_posix() for file in files))
        elif path.is_file():
            print(path.read_text(encoding="utf-8"), end="")
        else:
            print(f"There is no {line.strip()} in {workspace().name}/. Is the name right, was the cell above run?")

    def _words(self, line: str) -> tuple[dict[str, str], list[str], bool]:
        """Return the result of `_read` for a line, with the values of names in braces and after `$` inserted."""
        values = Values()
        options, argv, background = _read(values.expanded(self.shell, line))
        told = {name: values.restored(value) for name, value in options.items()}
        return told, [values.restored(word) for word in argv], background


def _read(line: str) -> tuple[dict[str, str], list[str], bool]:
    """Split a line into coursekit's own options (before the command), the command, and whether it ends with `&`."""
    words = split_words(line)
    background = bool(words) and words[-1] == "&"
    words = words[:-1] if background else words
    options: dict[str, str] = {}
    while words and words[0] in ("--name", "--stop-after", "--until", "--workspace"):
        options[words[0][2:]] = words[1]
        words = words[2:]
    return options, words, background


def _title(argv: list[str]) -> str:
    """Return the title of a terminal: the executable or launch file of `run` and `launch`, else the command."""
    if argv[:1] in (["run"], ["launch"]) and len(argv) > 2:
        return argv[2]
    return " ".join(argv[:3])


def _to_cell(background: bool, change: Any = str) -> Any:
    """Return the output sink: the waiting cell, or None for only the terminal."""
    if background:
        return None
    cell = contextvars.copy_context()  # identifies the cell, also in the reader thread of a child process
    return lambda stream, text: cell.copy().run(print, _without_folders(change(text)), end="")


def _without_folders(text: str) -> str:
    """Replace the course folder by `~` on the virtual clock, where every run must print the same."""
    folder = str(workspace().parent)
    quoted = folder.replace("\\", "\\\\")  # as in the repr of a Windows path
    return text.replace(quoted, "~").replace(folder, "~") if current().clock.virtual else text


def _without_durations(text: str) -> str:
    """Replace the build durations, for runs that must print the same."""
    return _DURATION.sub("[0.00s", text)


def workspace() -> Path:
    """Return the student's workspace."""
    return Path(os.environ.get("COURSEKIT_WORKSPACE", "ros2_ws")).resolve()


def _attend(begin: Callable[[], Any], title: str, options: dict[str, str], background: bool) -> Terminal | None:
    """Start a process and wait for it, or give it a terminal that can restart it."""
    process = begin()
    if background:
        shown = Terminal(process, title, again=lambda: adopt(shown.process, begin()))
        show_as(title, shown)
        return shown
    least = float(options["stop-after"]) if "stop-after" in options else None
    said = True
    try:
        if "until" in options:
            said = until_said(process, options["until"], least or 0.0, repeated=False)
        else:
            process.wait(least)
    except KeyboardInterrupt:
        pass
    if process.exit_code is None:
        _end(process)
        if not said:
            print(_nothing_said(options["until"]))
    return None


def _nothing_said(text: str) -> str:
    return gettext(f'"{text}" did not come, so the program was ended. Is a cell or an exercise above not done yet?')


def _end(process: BaseProcess) -> None:
    """Press Ctrl-C; kill the process if that does not help."""
    process.interrupt()
    if process.wait(5.0) is None:
        print(gettext(f"{process.name} ignores Ctrl-C; it was terminated."))
        process.kill()
        process.wait(2.0)


def workspace_environment(folder: str | None = None) -> dict[str, str]:
    """Return the environment after `source install/setup.bash` of the workspace, if it has been built."""
    env = dict(os.environ)
    install = (Path(folder).resolve() if folder else workspace()) / "install"
    if install.is_dir():
        from coursekit.packages.overlay import overlay_environment

        env = overlay_environment(install, env)
    return env


__all__ = ["CourseMagics", "edit", "show_as", "terminal", "terminals"]
