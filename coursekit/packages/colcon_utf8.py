"""colcon in UTF-8: it writes paths into Python files, which Python cannot read if they are in the code page's encoding."""

from __future__ import annotations

import os
import subprocess
import sys
from typing import Any

from colcon_core.argument_parser import ArgumentParserDecoratorExtensionPoint
from colcon_core.plugin_system import satisfies_version

from coursekit.systems import operating_system
from coursekit.systems.children import with_utf8


class InUtf8(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """On Windows, restarts colcon in Python's UTF-8 mode: otherwise setup.py could not find a folder `José`."""

    PRIORITY = 200  # before all others

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser; if colcon has to restart, exit with the new process's exit code."""
        if operating_system.WINDOWS and not sys.flags.utf8_mode:
            command = [sys.executable, "-X", "utf8", "-m", "colcon", *sys.argv[1:]]
            raise SystemExit(subprocess.call(command, env=with_utf8(os.environ)))
        return parser
