"""The class as a whole: mean, spread, the hardest questions, and a picture."""

from __future__ import annotations

import json
import statistics
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from coursekit.files import write_whole

if TYPE_CHECKING:
    from .mark import Marked


def summary(marks: Sequence[Marked], statuses: Mapping[str, int]) -> dict[str, Any]:
    """Numbers over those who handed in; shares of the points for each question; how many there are of each status."""
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
        "status": dict(sorted(statuses.items())),
        "questions": {name: round(statistics.fmean(values), 3) for name, values in sorted(shares.items())},
    }


def write_statistics(folder: Path, marks: Sequence[Marked], statuses: Mapping[str, int]) -> None:
    """statistics.json and histogram.png."""
    found = summary(marks, statuses)
    write_whole(folder / "statistics.json", json.dumps(found, indent=1).encode(), parents=True)
    from matplotlib.figure import Figure

    questions = found["questions"]
    figure: Any = Figure(figsize=(9, max(3.2, 0.9 + 0.25 * len(questions))), layout="constrained")
    totals, shares = figure.subplots(1, 2, width_ratios=(3, 2))
    _draw_totals(totals, marks, found)
    shares.barh(list(questions), [100 * share for share in questions.values()], color="#2f7d8c", height=0.6)
    shares.set(xlim=(0, 100), xlabel="% of the points, on average")
    shares.invert_yaxis()
    for axes in (totals, shares):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(folder / "histogram.png", dpi=120)


def _draw_totals(axes: Any, marks: Sequence[Marked], found: Mapping[str, Any]) -> None:
    """How many students have how many points: a bar stands over its points."""
    from matplotlib.ticker import MaxNLocator

    most = max((sum(verdict.of for verdict in one.verdicts) for one in marks), default=1.0)
    width = max(1.0, most / 30)
    edges = [width * (number - 0.5) for number in range(int(most / width) + 3)]
    axes.hist([one.total() for one in marks], bins=edges, color="#2f7d8c", edgecolor="white")
    axes.axvline(found["mean"], color="#b3392f", linewidth=1)
    said = f"{found['students']} students, mean {found['mean']:.1f} of {most:g}"
    axes.set(xlim=(-0.6 * width, most + 0.6 * width), xlabel="points", ylabel="students", title=said)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=True))
