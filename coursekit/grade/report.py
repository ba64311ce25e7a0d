"""A page for each student: points, their code beside what was expected and seen; and Gradescope's results.json."""

from __future__ import annotations

import html
import json
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from coursekit.files import write_whole

from .harmless import lines, number, shown
from .mark import Marked
from .record import Record
from .verdict import Verdict

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>{student}</title>
<style>body{{font:16px/1.5 system-ui,sans-serif;max-width:76rem;margin:2rem auto;padding:0 1rem;color:#1f2a30}}
h1{{font-size:1.5rem}} h2{{font-size:1.1rem;margin-top:1.8rem}} .comment{{border-left:4px solid #2f7d8c;padding:4px 12px}}
.total{{font-size:1.2rem}} footer,.how{{color:#5c686f;font-size:.85rem}} footer{{margin-top:2rem}}
.work{{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:1rem;margin:.8rem 0;align-items:start}}
@media(max-width:50rem){{.work{{grid-template-columns:1fr}}}}
pre{{background:#f5f7f8;padding:.6rem .8rem;margin:4px 0;overflow:auto;max-height:26rem;font-size:.82rem}}</style></head>
<body><h1>{student}</h1><p class="total"><b>{points}</b> of {of} points{off}</p>{comments}{notes}
{verdicts}<footer>{status}{late}; run in the sandbox <code>{tier}</code></footer></body></html>
"""


def page(record: Record) -> str:
    """The report as HTML."""
    marked, total, code = record.marked(), record.total(), record.code()
    improve = [verdict for verdict in marked.verdicts if not verdict.passed]
    right = [verdict for verdict in marked.verdicts if verdict.passed]
    parts = ["<h2>To improve</h2>" if improve else "", *(_beside(one, record, code) for one in improve)]
    parts += ["<h2>Right</h2>" if right else "", *(_beside(one, record, code) for one in right)]
    notes = "".join(f"<li>{_text(note)}</li>" for note in [*record.handed.open, *marked.notes])
    off = max((one.percent_off for one in record.late.values()), default=0.0)
    written = [(name, text) for name, text in record.extra.items() if text]
    said = "".join(f"<p class='comment'><b>{_text(name)}</b>: {_text(text)}</p>" for name, text in written)
    return _PAGE.format(
        student=_text(record.label),
        points="no mark yet" if total is None else number(total),
        of=number(record.of()),
        off=f" ({number(off)} % off for being late)" if off else "",
        comments=said,
        notes=f"<ul>{notes}</ul>" if notes else "",
        verdicts="\n".join(part for part in parts if part),
        status=_text(record.status().capitalize()),
        tier=_text(marked.tier or "none"),
        late=f"; {number(marked.minutes_late)} minutes late by {_text(record.time_from())}" if marked.minutes_late else "",
    )


def _beside(verdict: Verdict, record: Record, code: dict[str, str]) -> str:
    """A verdict, and the student's code beside it."""
    hand = "<p class='how'>These points were given by hand.</p>" if verdict.name in record.by_hand else ""
    text = code.get(verdict.name, "")
    own = f"<pre>{html.escape(lines(text))}</pre>" if text else "<p class='how'>Nothing was handed in for this.</p>"
    return f"<div class='work' id='{_text(verdict.name)}'><div>{_plain(verdict).html()}{hand}</div><div>{own}</div></div>"


def _plain(one: Verdict) -> Verdict:
    """What was seen is the student's own text: nothing in it may turn or hide the page."""
    values: dict[str, Any] = asdict(one)
    texts = {name: lines(value) for name, value in values.items() if isinstance(value, str)}
    return Verdict(**{**values, **texts})


def _text(text: str) -> str:
    return html.escape(shown(text, 600), quote=True)


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


def write_reports(folder: Path, records: Sequence[Record]) -> None:
    """KEY.html for everybody; KEY.results.json for whom there is a mark."""
    for one in records:
        write_whole(folder / f"{one.key}.html", page(one).encode("utf-8", "replace"), parents=True)
        total, scores = one.total(), folder / f"{one.key}.results.json"
        if total is None:
            scores.unlink(missing_ok=True)
            continue
        write_whole(scores, json.dumps({**gradescope(one.marked()), "score": total}, indent=1).encode(), parents=True)
