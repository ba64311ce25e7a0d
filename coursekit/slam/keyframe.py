"""A scan that is kept in the map."""

from __future__ import annotations

from typing import NamedTuple

from coursekit.slam.scan import Scan


class Keyframe(NamedTuple):
    """A scan that is kept; its pose is the graph node with the same number."""

    number: int
    scan: Scan
