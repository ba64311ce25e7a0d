"""What a class hands in, and a teacher's tables."""

from __future__ import annotations

import io
import json
import zipfile
from functools import cache
from pathlib import Path
from typing import Any

from .format import ROOT, TEXT, Faults, Format, values_only


def _table(path: Path) -> Any:
    from coursekit.grade.tables import read_table

    return read_table(path)


def _roster(path: Path) -> Any:
    from coursekit.grade.roster import Roster

    return Roster.read(path)


def _policy(path: Path) -> Any:
    from coursekit.grade.lateness import read_policy

    return read_policy(path, None)


ROSTER = "\ufeffStudent ID;Given name;Family name;E-mail\na001;Ana;García López;ana@uni.example\na002;Ben;Ito;\n".encode()
POLICY = b"""due = "2026-11-23T12:00"
percent_per_day = 10
floor_percent = 50
count = "newest"
[extensions]
Ana = 2
Ben = 2026-11-30 12:00:00
"""


def _notebook(path: Path) -> Any:
    from coursekit.grade.recognising import parse_notebook

    return parse_notebook(path.read_bytes(), path.name)


def _archive(path: Path) -> Any:
    from coursekit.grade.archives import Archive

    with Archive(io.BytesIO(path.read_bytes())) as opened:
        return [opened.read(member) for member in opened.members()]


def _bundle(path: Path) -> Any:
    from coursekit.grade.bundle import bundle_faults

    return bundle_faults(path.read_bytes())


@cache
def _zip() -> bytes:
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr("02_topics.ipynb", json.dumps({"cells": [], "metadata": {}}))
        packed.writestr("a/b.txt", b"x" * 300)
    return buffer.getvalue()


@cache
def _sealed() -> bytes:
    from coursekit.grade.bundle import pack_bundle

    return pack_bundle({"02_topics.ipynb": b"{}"}, {"student": "Ann", "notebook": "02_topics.ipynb", "time": "2026-11-23"})


def _archive_faults() -> Faults:
    from coursekit.grade.archives import BadArchive

    return BadArchive, ValueError


FORMATS = (
    Format("table", ".csv", lambda: ROSTER, _table, values_only, TEXT),
    Format("roster", ".csv", lambda: ROSTER, _roster, values_only, TEXT),
    Format("late policy", ".toml", lambda: POLICY, _policy, values_only, TEXT),
    Format("notebook", ".ipynb", (ROOT / "notebooks" / "00_start_here.ipynb").read_bytes, _notebook, values_only, TEXT),
    Format("zip", ".zip", _zip, _archive, _archive_faults),
    Format("bundle", ".zip", _sealed, _bundle, _archive_faults),
)  # fmt: skip
