"""The class as a whole: mean, spread, the hardest questions, and a picture."""

from __future__ import annotations

import json
import statistics
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .mark import Marked


def summary(marks: Sequence[Marked]) -> dict[str, Any]:
    """Numbers over the class; shares of the points for each question."""
    totals = [one.total() for one in marks]
    shares: dict[str, list[float]] = {}
    for one in marks:
        for verdict in one.verdicts:
            shares.setdefault(verdict.name, []).append(verdict.points / verdict.of if verdict.of else 0.0)
    return {
        "students": len(marks),
        "mean": round(statistics.fmean(totals), 3) if totals else 0.0,
        "median": statistics.median(totals) if totals else 0.0,
        "standard_deviation": round(statistics.pstdev(totals), 3) if totals else 0.0,
        "status": {status: sum(one.status == status for one in marks) for status in sorted({m.status for m in marks})},
        "questions": {name: round(statistics.fmean(values), 3) for name, values in sorted(shares.items())},
    }


def write_statistics(folder: Path, marks: Sequence[Marked]) -> None:
    """statistics.json and histogram.png."""
    (folder / "statistics.json").write_text(json.dumps(summary(marks), indent=1), encoding="utf-8")
    from matplotlib.figure import Figure

    figure = Figure(figsize=(7, 3.5), layout="constrained")
    axes = figure.subplots()
    most = max((sum(verdict.of for verdict in one.verdicts) for one in marks), default=1.0)
    axes.hist([one.total() for one in marks], bins=20, range=(0, most or 1), color="#2f7d8c", edgecolor="white")
    axes.set_xlabel("points")
    axes.set_ylabel("students")
    axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(folder / "histogram.png", dpi=120)
