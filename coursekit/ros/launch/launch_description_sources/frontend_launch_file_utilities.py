"""Loads XML and YAML launch files."""

from __future__ import annotations

from ..frontend import Parser
from ..launch_description import LaunchDescription


def get_launch_description_from_frontend_launch_file(
    launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the description in an XML or YAML launch file."""
    root, file_parser = parser.load(launch_file_path)
    return file_parser.parse_description(root)
