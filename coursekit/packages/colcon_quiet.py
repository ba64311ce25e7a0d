"""Warnings that a build on a robot does not give: newer setuptools' deprecations, coursekit's folder without setup files."""

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
"""How warnings begin that Humble's setuptools does not give, or says in a line."""


class Quiet(ArgumentParserDecoratorExtensionPoint):  # type: ignore[misc]
    """Has every Python that colcon starts leave these warnings out; what the user asks of warnings comes first."""

    PRIORITY = 150

    def __init__(self) -> None:
        super().__init__()
        satisfies_version(ArgumentParserDecoratorExtensionPoint.EXTENSION_POINT_VERSION, "^1.0")

    def decorate_argument_parser(self, *, parser: Any) -> Any:
        """Return the parser as it is."""
        said = os.environ.get("PYTHONWARNINGS", "")
        filters = [f"ignore:{one}" for one in NOT_HUMBLE_S]
        os.environ["PYTHONWARNINGS"] = ",".join([*filters, *filter(None, [said])])  # of several the last counts
        _as_if_warned_of(str(UNDERLAY))
        return parser


def _as_if_warned_of(prefix: str) -> None:
    """Have colcon say nothing of a prefix without setup files: it says so once of each, and remembers of which."""
    with contextlib.suppress(ImportError, AttributeError):  # a newer colcon-ros may keep that elsewhere: then it warns
        from colcon_ros.prefix_path import ament

        ament._get_ament_prefix_path_warnings.add(prefix)
