"""The base of verbs that packages add."""

from __future__ import annotations

from typing import Any


class VerbExtension:
    """One verb of a command: `add_arguments(parser, cli_name)`, then `main(args=...)`, whose return is the exit code."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def add_arguments(self, parser: Any, cli_name: str) -> None:
        """Add the verb's arguments."""

    def main(self, *, args: Any) -> Any:
        """Carry it out."""
        raise NotImplementedError()
