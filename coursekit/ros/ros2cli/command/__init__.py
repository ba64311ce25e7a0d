"""The base of commands that packages add."""

from __future__ import annotations

from typing import Any


class CommandExtension:
    """One command: `add_arguments(parser, cli_name)`, then `main(parser=..., args=...)`, whose return is the exit code."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def add_arguments(self, parser: Any, cli_name: str, *, argv: Any = None) -> None:
        """Add the command's arguments."""

    def main(self, *, parser: Any, args: Any) -> Any:
        """Carry it out."""
        raise NotImplementedError()
