"""Expansion of xacro files to URDF text."""

from __future__ import annotations

import contextlib
import io
import os
import threading
from collections.abc import Mapping
from typing import Any
from xml.parsers.expat import ExpatError

from .errors import UrdfError

UNBOUND = 'Declare xacro: <robot name="..." xmlns:xacro="http://www.ros.org/wiki/xacro">.'
_alone = threading.Lock()
"""xacro keeps its state in module globals."""


def expand(path: str | os.PathLike[str], arguments: Mapping[str, str] | None = None) -> str:
    """Return the output of `xacro PATH name:=value ...`; `$(find package)` uses the ament index. Raises UrdfError.

    In ROS 2: `ros2 run xacro xacro PATH`, or `Command(['xacro ', path])` in a launch file.

    >>> import pathlib, tempfile
    >>> text = '<robot name="ball" xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:arg name="base" default="base_link"/>'
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder, "ball.urdf.xacro")
    ...     _ = file.write_text(text + '<link name="$(arg base)"/></robot>', encoding="utf-8")
    ...     print(expand(file, {"base": "body"}).splitlines()[-2].strip())
    <link name="body"/>
    """
    import xacro

    from .expressions import evaluate

    xacro.safe_eval = evaluate
    file = os.fspath(path)
    said = io.StringIO()
    with _alone, contextlib.redirect_stderr(said):
        try:
            document = xacro.process_file(file, mappings=dict(arguments or {}))
        except ExpatError as error:
            cure = UNBOUND if "unbound prefix" in str(error) else "A tag, a quote or an & is not closed there."
            raise UrdfError(f"XML parser error: {error}", file=file, line=error.lineno, cure=cure) from None
        except (Exception, SystemExit) as error:
            raise _fault(error, file, said.getvalue()) from None
    return str(document.toprettyxml(indent="  "))


def _fault(error: BaseException, file: str, said: str) -> UrdfError:
    """Convert xacro's error to one with the file in which it occurred."""
    stack: list[Any] = list(getattr(__import__("xacro"), "filestack", None) or [])
    named = [str(place) for place in stack if place]
    inner = named[-1] if named else file
    lines = [line for line in said.splitlines() if line.strip()]
    what = str(error) or type(error).__name__
    if isinstance(error, SystemExit) and lines:
        what = lines[-1]
    within = f" (included by {file})" if inner != file else ""
    cure = "Look at the names in ${...} and $(...), and at the macro's parameters."
    if "PackageNotFoundError" in what:
        cure = "Build the workspace that holds the package, and source it."
    return UrdfError(f"xacro: {what}{within}", file=inner, cure=cure)


__all__ = ["expand"]
