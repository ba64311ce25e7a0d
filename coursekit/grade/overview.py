"""The class on one page: every student with their questions, what needs the teacher's eye, and work that is alike."""

from __future__ import annotations

import html
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import quote

from .similar import similar

if TYPE_CHECKING:
    from .mark import Marked
    from .verdict import Verdict

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>The class</title>
<style>body{{font:15px/1.45 system-ui,sans-serif;max-width:76rem;margin:2rem auto;padding:0 1rem;color:#1f2a30}}
h1{{font-size:1.5rem}} h2{{font-size:1.1rem;margin-top:2rem}} img{{max-width:100%}} table{{border-collapse:collapse}}
td,th{{padding:3px 9px;text-align:right;border-bottom:1px solid #e3e8ea;vertical-align:top;font-weight:400}}
th{{color:#68757d;position:sticky;top:0;background:#fff}} td:first-child,th:first-child,.words{{text-align:left}}
.all{{background:#e3f2e9}} .some{{background:#fbf3dc}} .none{{color:#b3392f}} .eye{{color:#b3392f}}
.words{{font-size:.88rem}} td:first-child{{white-space:nowrap}}</style>
</head><body><h1>The class</h1><p><img src="histogram.png" alt="How many students have how many points"></p>
<table><tr><th>student</th>{questions}<th>total</th><th>status</th><th>min late</th><th class="words">to look at</th></tr>
{rows}</table>{alike}</body></html>
"""
_MOST = 200
"""Pairs that are shown; similar.csv has them all."""


def overview(marks: Sequence[Marked]) -> str:
    """The page."""
    questions = sorted({verdict.name for one in marks for verdict in one.verdicts})
    return _PAGE.format(
        questions="".join(f"<th>{html.escape(name)}</th>" for name in questions),
        rows="\n".join(_row(one, questions) for one in marks),
        alike=_alike(marks),
    )


def _row(marked: Marked, questions: Sequence[str]) -> str:
    verdicts = {verdict.name: verdict for verdict in marked.verdicts}
    cells = "".join(_cell(verdicts.get(name)) for name in questions)
    eye = [f"<span class='eye'>{html.escape(one)}</span>" for one in marked.concerns]
    words = "<br>".join([*eye, *(html.escape(one) for one in marked.notes)])
    late = f"{marked.minutes_late:g}" if marked.minutes_late else ""
    return (
        f"<tr><td>{_link(marked.student)}</td>{cells}<td><b>{marked.total():g}</b></td><td>{html.escape(marked.status)}</td>"
        f"<td>{late}</td><td class='words'>{words}</td></tr>"
    )


def _cell(verdict: Verdict | None) -> str:
    if verdict is None:
        return "<td></td>"
    kind = "all" if verdict.passed else "some" if verdict.points else "none"
    return f"<td class='{kind}' title='{html.escape(verdict.got or verdict.title, quote=True)}'>{verdict.points:g}</td>"


def _link(student: str) -> str:
    return f"<a href='{quote(student)}.html'>{html.escape(student)}</a>"


def _alike(marks: Sequence[Marked]) -> str:
    """Pairs whose work is nearly one: where to look, not a verdict."""
    pairs = similar(marks)
    rows = "".join(
        f"<tr><td>{_link(one)}</td><td class='words'>{_link(other)}</td><td>{100 * likeness:.0f} %</td></tr>"
        for one, other, likeness in pairs[:_MOST]
    )
    more = f"<p>{len(pairs) - _MOST} more are in similar.csv.</p>" if len(pairs) > _MOST else ""
    return f"<h2>Work that is alike</h2><table>{rows}</table>{more}" if pairs else ""


def write_overview(folder: Path, marks: Sequence[Marked]) -> None:
    """class.html."""
    (folder / "class.html").write_text(overview(marks), encoding="utf-8")
