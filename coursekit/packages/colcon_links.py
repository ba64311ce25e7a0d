"""`colcon build --symlink-install` where links are refused, as for most accounts on Windows: it copies, and says so."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from colcon_core.argument_parser import ArgumentParserDecorator, ArgumentParserDecoratorExtensionPoint
from colcon_core.plugin_system import satisfies_version

from coursekit.systems.links import can_link

COPIES = (
    "--symlink-install copies here, since this account may not make links: "
    "run `colcon build` again after every change of a file"
)


class LinksWherePossible(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """Looks at the parsed command line of every verb."""

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser with the look behind it."""
        return _Looking(parser)


class _Looking(ArgumentParserDecorator):  # type: ignore[misc]
    def parse_args(self, *args: Any, **kwargs: Any) -> argparse.Namespace:
        parsed: argparse.Namespace = self._parser.parse_args(*args, **kwargs)
        if getattr(parsed, "symlink_install", False) and not can_link(Path(parsed.build_base).resolve()):
            parsed.symlink_install = False
            print(COPIES, flush=True)
        return parsed
