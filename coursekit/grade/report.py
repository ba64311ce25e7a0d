"""A page for each student: points, what was expected and seen, what to improve; and Gradescope's results.json."""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from .mark import Marked

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{student}</title>
<style>body{{font:16px/1.5 system-ui,sans-serif;max-width:46rem;margin:2rem auto;padding:0 1rem;color:#1f2a30}}
h1{{font-size:1.5rem}} h2{{font-size:1.1rem;margin-top:1.8rem}}
.total{{font-size:1.2rem}} footer{{color:#68757d;font-size:.85rem;margin-top:2rem}}</style></head>
<body><h1>{student}</h1><p class="total"><b>{points:g}</b> of {of:g} points</p>{notes}
{verdicts}<footer>{status}{late}; run in the sandbox <code>{tier}</code></footer></body></html>
"""


def page(marked: Marked) -> str:
    """The report as HTML."""
    improve = [verdict for verdict in marked.verdicts if not verdict.passed]
    right = [verdict for verdict in marked.verdicts if verdict.passed]
    parts = ["<h2>To improve</h2>" if improve else "", *(one.html() for one in improve)]
    parts += ["<h2>Right</h2>" if right else "", *(one.html() for one in right)]
    notes = "".join(f"<li>{html.escape(note)}</li>" for note in marked.notes)
    return _PAGE.format(
        student=html.escape(marked.student),
        points=marked.total(),
        of=sum(verdict.of for verdict in marked.verdicts),
        notes=f"<ul>{notes}</ul>" if notes else "",
        verdicts="\n".join(part for part in parts if part),
        status=html.escape(marked.status.capitalize()),
        tier=html.escape(marked.tier),
        late=f"; {marked.minutes_late:g} minutes late" if marked.minutes_late else "",
    )


def gradescope(marked: Marked) -> dict[str, Any]:
    """What Gradescope reads."""
    tests = [
        {
            "name": f"{verdict.name} {verdict.title}",
            "score": verdict.points,
            "max_score": verdict.of,
            "status": "passed" if verdict.passed else "failed",
            "output": verdict.text(),
            "output_format": "text",
            "visibility": "visible",
        }
        for verdict in marked.verdicts
    ]
    return {"score": marked.total(), "output": "\n".join(marked.notes), "output_format": "text", "tests": tests}


def write_reports(folder: Path, marks: Sequence[Marked]) -> None:
    """NAME.html and NAME.results.json for every student."""
    for one in marks:
        (folder / f"{one.student}.html").write_text(page(one), encoding="utf-8")
        (folder / f"{one.student}.results.json").write_text(json.dumps(gradescope(one), indent=1), encoding="utf-8")
