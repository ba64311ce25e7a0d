"""The base class of verbs that packages add."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from ros2cli.command import named
from ros2cli.plugin_system import PLUGIN_SYSTEM_VERSION, instantiate_extensions, satisfies_version

if TYPE_CHECKING:
    from argparse import ArgumentParser, Namespace


class VerbExtension:
    """One verb of a command: `add_arguments(parser, cli_name)`, then `main(args=...)`, whose return is the exit code."""

    NAME: str | None = None
    EXTENSION_POINT_VERSION = "0.1"

    def __init__(self) -> None:
        satisfies_version(PLUGIN_SYSTEM_VERSION, "^0.1")

    def add_arguments(self, parser: ArgumentParser, cli_name: str) -> None:
        """Add the verb's arguments."""

    def main(self, *, args: Namespace) -> Any:
        """Run the verb."""
        raise NotImplementedError()


def get_verb_extensions(name: str) -> dict[str, Any]:
    """The verbs that packages add to a group, by name."""
    return named(instantiate_extensions(name))
