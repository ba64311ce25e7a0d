"""Extensions: classes that packages add as entry points."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from typing import Any

from ros2cli.entry_points import load_entry_points

PLUGIN_SYSTEM_VERSION = "0.1"


def instantiate_extensions(
    group_name: str, *, exclude_names: Sequence[str] | None = None, unique_instance: bool = False
) -> dict[str, Any]:
    """An instance of each class of a group, by name. Failures are reported and left out."""
    extensions = {}
    for name, kind in load_entry_points(group_name, exclude_names=exclude_names).items():
        try:
            extensions[name] = kind()
        except Exception as error:
            print(f"Failed to instantiate '{name}' of group '{group_name}': {error!r}", file=sys.stderr)
    return extensions


def satisfies_version(version: str, caret_range: str) -> None:
    """Check a version against the range that an extension was written for.

    >>> satisfies_version("0.1", "^0.1")

    Raises:
        RuntimeError: if the version is older than the range or incompatible with it.
    """
    assert caret_range.startswith("^"), "Only supports caret ranges"
    least, asked = (tuple(int(part) for part in text.split(".")) for text in (caret_range[1:], version))
    if asked < least:
        raise RuntimeError(f"Extension point version '{version}' is too old. Should satisfy '{caret_range}'")
    fixed = 1 if least[0] else 2
    if asked[:fixed] != least[:fixed]:
        raise RuntimeError(f"Extension point version '{version}' is incompatible. Should satisfy '{caret_range}'")


def get_first_line_doc(any_type: Any) -> str:
    """The first line of an object's docstring, without its full stop."""
    lines = (any_type.__doc__ or "").strip().splitlines()
    return lines[0].removesuffix(".") if lines else ""
