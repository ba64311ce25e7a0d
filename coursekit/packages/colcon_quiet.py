"""Suppresses warnings that robots do not give: newer setuptools' deprecations, coursekit's folder without setup files."""

from __future__ import annotations

import contextlib
import os
from typing import Any

from colcon_core.argument_parser import ArgumentParserDecoratorExtensionPoint
from colcon_core.plugin_system import satisfies_version

from coursekit.interfaces.find import UNDERLAY

NOT_HUMBLE_S = (
    "Invalid dash-separated",
    "Usage of dash-separated",
    "License classifiers are deprecated",
    "setup.py install is deprecated",
    "easy_install command is deprecated",
    "Deprecated config in",
    "pkg_resources is deprecated",
    "Requirements should be satisfied by a PEP 517 installer",
)
"""The beginnings of warnings that Humble's setuptools does not print, or prints in one line."""


class Quiet(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """Adds filters for these warnings for every Python process of colcon; the user's own filters take precedence."""

    PRIORITY = 150

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser unchanged."""
        said = os.environ.get("PYTHONWARNINGS", "")
        filters = [f"ignore:{text}" for text in NOT_HUMBLE_S]
        os.environ["PYTHONWARNINGS"] = ",".join([*filters, *filter(None, [said])])  # the last matching one applies
        _as_if_warned_of(str(UNDERLAY))
        return parser


def _as_if_warned_of(prefix: str) -> None:
    """Suppress colcon's warning about a prefix without setup files: it warns once for each, and remembers them."""
    with contextlib.suppress(ImportError, AttributeError):  # a newer colcon-ros may store them elsewhere: then it warns
        from colcon_ros.prefix_path import ament

        ament._get_ament_prefix_path_warnings.add(prefix)
