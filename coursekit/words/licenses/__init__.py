"""Texts of the licenses that `ros2 pkg create` can add to a package, and that `ament_copyright` recognizes."""

from __future__ import annotations

from pathlib import Path

NAMES = (
    "Apache-2.0",
    "BSL-1.0",
    "BSD-2.0",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "GPL-3.0-only",
    "LGPL-3.0-only",
    "MIT",
    "MIT-0",
)


def text(name: str) -> str | None:
    """Return the text of a license, or None for an unknown one."""
    if name not in NAMES:
        return None
    return (Path(__file__).parent / f"{name}.txt").read_text(encoding="utf-8")
