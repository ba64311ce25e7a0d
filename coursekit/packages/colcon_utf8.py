"""colcon in UTF-8: it writes paths into Python files, which Python cannot read if they are in the code page's encoding.

In UTF-8 mode it also expects UTF-8 of its shell. Windows' shell writes the console's code page, and colcon would drop every
variable that names a folder `José`. It writes UTF-16 when it is asked to, so that is what it is asked for.
"""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

from colcon_core import shell
from colcon_core.argument_parser import ArgumentParserDecoratorExtensionPoint
from colcon_core.plugin_system import satisfies_version
from colcon_core.subprocess import check_output

from coursekit.systems import operating_system
from coursekit.systems.children import with_utf8

_MARK = "coursekit_variables_follow"
"""Printed after what the setup scripts print, which is in the console's code page."""


class InUtf8(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """On Windows, restarts colcon in Python's UTF-8 mode: otherwise setup.py could not find a folder `José`."""

    PRIORITY = 200  # before all others

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser; if colcon has to restart, exit with the new process's exit code."""
        if not operating_system.WINDOWS:
            return parser
        if not sys.flags.utf8_mode:
            command = [sys.executable, "-X", "utf8", "-m", "colcon", *sys.argv[1:]]
            raise SystemExit(subprocess.call(command, env=with_utf8(os.environ)))
        shell.check_output = output_in_utf8
        return parser


async def output_in_utf8(args: list[str], **options: Any) -> bytes:
    """Call colcon's `check_output`; what cmd's `set` prints at the end of the command is in UTF-8."""
    if args[-1] != "set":
        return bytes(await check_output(args, **options))
    output = await check_output([*args[:-1], "echo", _MARK, "&&", "cmd", "/d", "/u", "/c", "set"], **options)
    _said, _, marked = output.partition(_MARK.encode())
    variables = marked.partition(b"\n")[2]
    return bytes(variables.decode("utf-16-le").encode())
