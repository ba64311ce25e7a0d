"""The logs of the SLAM benchmark, which are not ours to hand on: they are looked for, never copied."""

from __future__ import annotations

import os
from pathlib import Path

LOGS = {"fr079": "fr079.clf.xz", "Intel": "intel_first5505.clf.xz"}
MISSING = "the benchmark logs are not here: set COURSEKIT_SLAM_DATA to their folder"


def folder() -> Path | None:
    """Where the logs are, None when they are not here."""
    beside = Path(__file__).resolve().parents[3] / "shared" / "data" / "slam"
    place = Path(os.environ.get("COURSEKIT_SLAM_DATA") or beside)
    return place if all((place / name).is_file() for name in LOGS.values()) else None


def files(name: str) -> tuple[Path, Path]:
    """A log and its relations."""
    place = folder()
    assert place is not None, MISSING
    log = place / LOGS[name]
    return log, place / log.name.replace(".clf.xz", ".relations")
