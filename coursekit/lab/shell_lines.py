"""`!command` on Windows: its output appears in its cell, in UTF-8 and in order, as on Linux.

There IPython reads the output in threads that are not joined and belong to no cell.
"""

from __future__ import annotations

import functools
import os
import subprocess

from IPython.core.interactiveshell import InteractiveShell

from coursekit.processes.patching import KERNEL, Change, Patch
from coursekit.systems import operating_system
from coursekit.systems.children import with_utf8

from . import cmd_words


def install(shell: InteractiveShell) -> None:
    """Install `run_line`, on Windows only."""
    if operating_system.WINDOWS:
        shell.system = functools.partial(run_line, shell)  # type: ignore[method-assign]


def patches() -> list[Patch]:
    """Return the changes to a kernel's shell, for as long as it runs."""
    reason, test = "on Windows what `!command` prints stands in its cell", "tests/lab/test_shell_lines.py"
    return [Change("IPython: shell.system", install, reason, test, KERNEL)]


def run_line(shell: InteractiveShell, line: str) -> None:
    """Run a line in the system shell; `{name}` and `$name` in it are variables of the notebook.

    Afterwards the notebook variable `_exit_code` holds the exit code.
    """
    command = shell.var_expand(line, depth=1)
    child = subprocess.Popen(
        command,
        shell=True,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        env=with_utf8(os.environ),
    )
    with child:
        assert child.stdout is not None
        for text in child.stdout:
            print(text, end="", flush=True)
    shell.user_ns["_exit_code"] = child.returncode
    if child.returncode and (hint := cmd_words.hint(command)):
        print(hint)


__all__ = ["install", "patches", "run_line"]
