"""Decides how a command is run: inside the session, or as a child process of the system."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

from coursekit.interfaces.find import UNDERLAY
from coursekit.processes import script, session
from coursekit.processes.child import ChildProcess
from coursekit.processes.executables import has_compiled_here
from coursekit.processes.prefixed import is_package_executable, prefixed
from coursekit.systems.command_lines import plain_words, shell_command
from coursekit.systems.layout import executable_name
from coursekit.wiring import COMPILED_HOST, command

from .substitutions.find_executable import which

TERMINALS = ("xterm", "gnome-terminal", "konsole", "lxterminal", "terminator", "xfce4-terminal")
OutputCallback = Callable[[str, str], None]


def start_process(
    cmd: Sequence[str],
    *,
    cwd: str | None,
    env: Mapping[str, str],
    shell: bool,
    on_output: OutputCallback,
    tty: bool = False,
) -> Any:
    """Start a command and return its process.

    Executables of packages, `ros2`, Python programs that use rclpy and C++ programs that were built here run inside the
    session, where they share its graph and clock. All other commands run as child processes of the system. With `shell`,
    the user's shell runs the text. A terminal window before the command is omitted. With `tty`, its output is a terminal.

    Raises:
        FileNotFoundError: if there is no such program.
    """
    current = session.current()
    cmd = prefixed(without_terminal(cmd))
    words = plain_words(" ".join(cmd)) if shell else list(cmd)
    name = executable_name(Path(words[0])) if words else ""
    run = command(name) if words and not is_package_executable(words[0]) else None
    if run is not None:
        argv = words[1:]
        return current.start(lambda: run(argv), name=name, argv=argv, env=env, cwd=cwd, on_output=on_output, tty=tty)
    program = script.of_command(words, cwd) if words else None
    if program is not None:
        path, argv = program
        return current.start_executable(path, argv, env=env, cwd=cwd, on_output=on_output, tty=tty)
    if shell:
        cmd = shell_command(" ".join(cmd), env)
    elif is_package_executable(cmd[0]):
        return current.start_executable(cmd[0], list(cmd[1:]), env=env, cwd=cwd, on_output=on_output, tty=tty)
    executable = which(cmd[0], env.get("PATH"))
    if executable is None:
        raise FileNotFoundError(2, "there is no such program", cmd[0])
    if has_compiled_here(cmd):
        host, name = UNDERLAY / COMPILED_HOST, os.path.basename(executable)
        words = [executable, *cmd[1:]]
        return current.start_executable(host, words, name=name, env=env, cwd=cwd, on_output=on_output, tty=tty)
    child = ChildProcess(current, [executable, *cmd[1:]], name=os.path.basename(cmd[0]), env=env, cwd=cwd)
    return current.launch(child, on_output, tty)


def without_terminal(cmd: Sequence[str]) -> Sequence[str]:
    """Return a command without the terminal window before it: the launch's own output replaces the window.

    >>> without_terminal(['xterm', '-e', 'teleop', '--ros-args'])
    ['teleop', '--ros-args']
    """
    if os.path.basename(cmd[0]) not in TERMINALS:
        return cmd
    for index, word in enumerate(cmd[:-1]):
        if word in ("-e", "-x", "--"):
            return cmd[index + 1 :]
    return cmd
