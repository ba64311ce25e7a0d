"""Statistics of the class: mean, spread, the hardest questions, and a picture. All pages and messages use these numbers.

Averages use the marks in the table's column `total`: with points by hand, after deductions for lateness, of those who
have a mark and a submission or points by hand. Shares of an exercise's points are before deductions.
"""

from __future__ import annotations

import json
import statistics
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from coursekit.files import write_whole
from coursekit.words.counting import counted

from .record import Record
from .sanitizing import number


def averaged(records: Sequence[Record]) -> list[float]:
    """Return the marks used in averages."""
    return [total for record in records if record.counts() and (total := record.total()) is not None]


def mean(marks: Sequence[float]) -> float:
    """Return the average, rounded to a hundredth of a point.

    >>> mean([7.22, 7.23])
    7.22
    """
    return round(statistics.fmean(marks), 2) if marks else 0.0


def average(records: Sequence[Record]) -> str:
    """Return the average and its basis as text."""
    marks, of = averaged(records), records[0].of() if records else 0.0
    if not marks:
        return "no average yet"
    whose = f"{counted(len(marks), 'student')} with work and a mark"
    return f"on average {mean(marks):.2f} of {number(of)} points after lateness ({whose})"


def shares(records: Sequence[Record]) -> dict[str, float]:
    """Return by exercise the average share of its points, for the students in the average, before deductions."""
    verdicts = [verdict for record in records if record.counts() for verdict in record.marked().verdicts]
    shares_by_name: dict[str, list[float]] = {}
    for lost in verdicts:
        shares_by_name.setdefault(lost.name, []).append(lost.points / lost.of if lost.of else 0.0)
    return {name: statistics.fmean(values) for name, values in sorted(shares_by_name.items())}


def summary(records: Sequence[Record], statuses: Mapping[str, int]) -> dict[str, Any]:
    """Return the numbers, with the number of students of each status."""
    marks = averaged(records)
    return {
        "students": len(records),
        "averaged": len(marks),
        "mean": mean(marks),
        "median": statistics.median(marks) if marks else 0.0,
        "standard_deviation": round(statistics.pstdev(marks), 3) if marks else 0.0,
        "of": records[0].of() if records else 0.0,
        "status": dict(sorted(statuses.items())),
        "questions": {name: round(share, 3) for name, share in shares(records).items()},
    }


def write_statistics(folder: Path, records: Sequence[Record], statuses: Mapping[str, int]) -> None:
    """Write statistics.json and histogram.png."""
    facts = summary(records, statuses)
    write_whole(folder / "statistics.json", json.dumps(facts, indent=1).encode(), parents=True)
    from matplotlib.figure import Figure

    questions = facts["questions"]
    figure: Any = Figure(figsize=(9, max(3.2, 0.9 + 0.25 * len(questions))), layout="constrained")
    totals, parts = figure.subplots(1, 2, width_ratios=(3, 2))
    _draw_totals(totals, averaged(records), facts)
    parts.barh(list(questions), [100 * share for share in questions.values()], color="#2f7d8c", height=0.6)
    parts.set(xlim=(0, 100), xlabel="% of the points, on average, before lateness")
    parts.invert_yaxis()
    for axes in (totals, parts):
        axes.spines[["top", "right"]].set_visible(False)
    figure.savefig(folder / "histogram.png", dpi=120)


def _draw_totals(axes: Any, marks: Sequence[float], facts: Mapping[str, Any]) -> None:
    """Draw the number of students by points: a bar is centred on its points."""
    from matplotlib.ticker import MaxNLocator

    most = max([facts["of"] or 1.0, *marks])
    width = max(1.0, most / 30)
    edges = [width * (place - 0.5) for place in range(int(most / width) + 3)]
    axes.hist(marks, bins=edges, color="#2f7d8c", edgecolor="white")
    axes.axvline(facts["mean"], color="#b3392f", linewidth=1)
    said = f"{counted(facts['averaged'], 'student')}, mean {facts['mean']:.2f} of {number(facts['of'])}"
    axes.set(xlim=(-0.6 * width, most + 0.6 * width), xlabel="points after lateness", ylabel="students", title=said)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(integer=True))
