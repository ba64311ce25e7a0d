"""A page for each student, with points and code beside expected and observed results; and Gradescope's results.json."""

from __future__ import annotations

import html
import json
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from coursekit.files import write_whole
from coursekit.words.gettext import gettext, language, speaking

from .lateness import late_by
from .mark import Marked
from .page_style import STYLE
from .pictures import as_html
from .record import COMMENT, ON_EXERCISE, Record
from .sanitizing import lines, number, shown
from .verdict import Verdict

_PAGE = """<!doctype html>
<html lang="{language}"><head><meta charset="utf-8"><title>{student}</title>
<style>{style}
body{{font:16px/1.5 system-ui,sans-serif;max-width:76rem;margin:2rem auto;padding:0 1rem}}
h1{{font-size:1.5rem}} h2{{font-size:1.1rem;margin-top:1.8rem}}
.comment{{border-left:4px solid var(--link);padding:4px 12px}}
.total{{font-size:1.2rem}} footer,.how{{color:var(--soft);font-size:.85rem}} footer{{margin-top:2rem}}
.work{{display:grid;grid-template-columns:minmax(0,1fr) minmax(0,1fr);gap:1rem;margin:.8rem 0;align-items:start}}
@media(max-width:50rem){{.work{{grid-template-columns:1fr}}}}
.evidence{{display:flex;flex-wrap:wrap;gap:1rem}} figure{{margin:0;max-width:36rem}} figure img{{max-width:100%}}
figcaption{{color:var(--soft);font-size:.8rem}}
pre{{background:var(--code);padding:.6rem .8rem;margin:4px 0;overflow:auto;max-height:26rem;font-size:.82rem;
white-space:pre-wrap;overflow-wrap:anywhere}}</style></head>
<body><h1>{student}</h1><p class="total">{total}{how}</p>{comments}{notes}
{verdicts}{evidence}<footer>
{footer}</footer></body></html>
"""


def page(record: Record, fields: Callable[[str], str] | None = None) -> str:
    """Return the report as HTML; `fields(exercise)` is inserted below each verdict for marking by hand.

    Students first see what they can improve, in the language of their notebooks; markers see the exercises in the
    same order on all pages.
    """
    with speaking(record.language() if fields is None else language()):
        return _page(record, fields)


def _page(record: Record, fields: Callable[[str], str] | None) -> str:
    marked, code = record.marked(), record.code()
    improve = [_beside(verdict, record, code) for verdict in marked.verdicts if not verdict.passed]
    right = [_beside(verdict, record, code) for verdict in marked.verdicts if verdict.passed]
    parts = [_head(gettext("To improve")) if improve else "", *improve, _head(gettext("Right")) if right else "", *right]
    if fields is not None:
        parts = [_beside(verdict, record, code, fields(verdict.name)) for verdict in marked.verdicts]
    notes = "".join(f"<li>{_text(_note(note))}</li>" for note in [*record.handed.open, *marked.notes])
    whole = record.extra.get(COMMENT, "")
    return _PAGE.format(
        language=language(),
        style=STYLE,
        student=_text(record.label),
        total=_total(record),
        how=_how(record),
        comments=f"<p class='comment'><b>{gettext('comment')}</b>: {_paragraphs(whole)}</p>" if whole else "",
        notes=f"<ul>{notes}</ul>" if notes else "",
        verdicts="\n".join(part for part in parts if part),
        evidence=as_html(record.handed.bundles()),
        footer=_footer(record, marked),
    )


def _head(title: str) -> str:
    return f"<h2>{title}</h2>"


def _soft(text: str) -> str:
    return f"<p class='how'>{text}</p>"


def _note(note: str) -> str:
    """Translate a note; if it begins with a file name, only the rest."""
    whole = gettext(note)
    where, colon, said = note.partition(": ")
    return f"{where}: {gettext(said)}" if colon and whole == note else whole


def _total(record: Record) -> str:
    total, of, chapters = record.total(), number(record.of()), _text(record.told_chapters())
    if total is None:
        return gettext(f"<b>no mark yet</b> of {of} points in {chapters}")
    return gettext(f"<b>{number(total)}</b> of {of} points in {chapters}")


def _how(record: Record) -> str:
    """Describe the origin of the total: by hand, or with deductions."""
    if record.total_by_hand():
        return gettext(", given by hand")
    off = record.told_off()
    return gettext(f", after {off} taken off for being late") if off else ""


def _footer(record: Record, marked: Marked) -> str:
    """Return the status, the lateness, and the sandbox."""
    parts = [f'<span class="status">{_text(gettext(record.status()).capitalize())}</span>']
    if marked.minutes_late:
        parts.append(gettext(f"{late_by(marked.minutes_late)} late by {_text(gettext(record.time_from()))}"))
    if marked.tier:
        parts.append(gettext(f"run in the sandbox <code>{_text(marked.tier)}</code>"))
    return "; ".join(parts)


def _beside(verdict: Verdict, record: Record, code: dict[str, str], form: str = "") -> str:
    """Return a verdict with the student's code beside it."""
    said = f"<div class='said'>{said_of(verdict, record)}</div>{form}"
    if not form and (comment := record.extra.get(verdict.name + ON_EXERCISE)):
        said += f"<p class='comment'>{_paragraphs(comment)}</p>"
    text = code.get(verdict.name, "")
    own = f"<pre>{html.escape(lines(text))}</pre>" if text else _soft(gettext("Nothing was handed in for this."))
    return f"<div class='work' id='{_text(verdict.name)}'><div>{said}</div><div>{own}</div></div>"


def said_of(verdict: Verdict, record: Record) -> str:
    """Return a verdict, and whether its points were given by hand."""
    hand = _soft(gettext("These points were given by hand.")) if verdict.name in record.by_hand else ""
    return _plain(verdict).html() + hand


def _paragraphs(text: str) -> str:
    return html.escape(lines(text), quote=True).replace("\n", "<br>")


def _plain(verdict: Verdict) -> Verdict:
    """Return a verdict with the student's text made safe: nothing in it can change or hide the page."""
    values: dict[str, Any] = asdict(verdict)
    texts = {name: lines(value) for name, value in values.items() if isinstance(value, str)}
    return Verdict(**{**values, **texts})


def _text(text: str) -> str:
    return html.escape(shown(text, 600), quote=True)


def gradescope(marked: Marked) -> dict[str, Any]:
    """Return the report in Gradescope's format."""
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
    """Write KEY.html for everybody, and KEY.results.json for those with a mark."""
    for record in records:
        write_whole(folder / f"{record.key}.html", page(record).encode("utf-8", "replace"), parents=True)
        total, scores = record.total(), folder / f"{record.key}.results.json"
        if total is None:
            scores.unlink(missing_ok=True)
            continue
        write_whole(scores, json.dumps({**gradescope(record.marked()), "score": total}, indent=1).encode(), parents=True)
