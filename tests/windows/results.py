"""What pytest wrote about each piece, as a table: how many passed, and the reasons of all that was skipped."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ET
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from . import wine

FOLDER = wine.HOME / "results"
NOT_ENDED = "did not run to its end"


@dataclass(frozen=True)
class Result:
    """What became of a piece's tests, or cells."""

    name: str
    passed: int = 0
    failed: tuple[str, ...] = ()
    skipped: Counter[str] = field(default_factory=Counter)
    """How many were skipped for which reason."""
    ended: bool = True

    def __str__(self) -> str:
        if not self.ended:
            return f"{self.name:<16} {NOT_ENDED}"
        failed, skipped = len(self.failed), self.skipped.total()
        total = self.passed + failed + skipped
        lines = [f"{self.name:<16} {self.passed:5} of {total} passed, {failed} failed, {skipped} skipped"]
        lines += [f"    FAILED {test_name}" for test_name in self.failed]
        lines += [f"    {count} skipped: {why}" for why, count in sorted(self.skipped.items())]
        return "\n".join(lines)


def file_of(name: str) -> Path:
    """Where pytest writes about the piece of that name."""
    return FOLDER / f"{name.replace(' ', '_')}.xml"


def forget(names: Iterable[str]) -> None:
    """Take away what earlier runs wrote."""
    FOLDER.mkdir(parents=True, exist_ok=True)
    for name in names:
        file_of(name).unlink(missing_ok=True)


def read(name: str) -> Result:
    """What the file about a piece says; none is there when pytest was ended."""
    try:
        cases = list(ET.parse(file_of(name)).iter("testcase"))
    except (FileNotFoundError, ET.ParseError):
        return Result(name, ended=False)
    skipped = Counter(_reason(case) for case in cases if case.find("skipped") is not None)
    bad = [case for case in cases if case.find("failure") is not None or case.find("error") is not None]
    failed = tuple(sorted({f"{case.get('classname')}::{case.get('name')}" for case in bad}))
    return Result(name, len(cases) - skipped.total() - len(bad), failed, skipped)


def table(names: Iterable[str]) -> str:
    """All pieces, one below the other."""
    return "\n".join(str(read(name)) for name in names)


def _reason(case: ET.Element) -> str:
    """Why a test was skipped, without the line of the file that pytest puts before it."""
    told = case.find("skipped")
    assert told is not None
    return re.sub(r"^Skipped: |\s+", " ", told.get("message") or "").strip()
