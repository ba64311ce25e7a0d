"""A scan that is kept."""

from __future__ import annotations

from dataclasses import dataclass

from coursekit.slam.scan import Scan


@dataclass(frozen=True)
class Keyframe:
    """A scan that is kept; its pose is the graph's node of the same number."""

    number: int
    scan: Scan
    travelled: float = 0.0
    """Way since the start [m]."""
