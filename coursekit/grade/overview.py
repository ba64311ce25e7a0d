"""The class on one page: students who need attention, the hardest exercises with frequent wrong answers, all points."""

from __future__ import annotations

import ast
import html
import re
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from urllib.parse import quote

from coursekit.files import write_whole

from .collector import Collection
from .lateness import late_by
from .outcome import Outcome
from .page_style import STYLE
from .record import Record
from .sanitizing import number, shown
from .similar import similar
from .statistics import average, shares
from .statuses import LOOK
from .verdict import Verdict

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><title>The class: {chapters}</title><link rel="icon" href="data:,">
<style>{style}
body{{font:15px/1.45 system-ui,sans-serif;max-width:80rem;margin:2rem auto;padding:0 1rem}}
h1{{font-size:1.5rem}} h2{{font-size:1.1rem;margin-top:2rem}} img{{max-width:100%}} table{{border-collapse:collapse}}
td,th{{padding:3px 7px;text-align:right;border-bottom:1px solid var(--line);vertical-align:top;font-weight:400}}
th{{color:var(--soft);position:sticky;top:0;background:var(--paper)}} td:first-child,th:first-child,.words{{text-align:left}}
.all{{background:var(--all)}} .some{{background:var(--some)}} .none,.eye{{color:var(--wrong)}}
.words{{font-size:.88rem;overflow-wrap:anywhere}} td:first-child,.late,.status{{white-space:nowrap}}
.below td{{padding-top:0}} tr:has(+ .below) td{{border-bottom:0}} .wrap td:first-child{{white-space:normal}}</style>
</head><body><h1>The class: {chapters}</h1>
<p>{counts}; {average}; run in the sandbox <code>{tier}</code></p>
{look}{hardest}<h2>All students</h2><p><img class="drawn" src="histogram.png" alt="Number of students by points"></p>
<table id="everybody">
<tr><th>student</th>{questions}<th>total</th><th>status</th><th>late by</th><th>taken off</th></tr>
{rows}</table>{alike}</body></html>
"""
_MOST = 200
"""The maximum number of pairs shown; similar.csv has them all."""


def overview(records: Sequence[Record], outcome: Outcome | None = None) -> str:
    """Return the page."""
    questions = sorted({verdict.name for record in records for verdicts in record.wanted.values() for verdict in verdicts})
    outcome = outcome or Outcome(list(records), Collection([], [], []))
    tiers = sorted({record.marked().tier for record in records} - {""})
    return _PAGE.format(
        style=STYLE,
        chapters=_text(records[0].told_chapters() if records else ""),
        counts=html.escape(outcome.line()),
        average=html.escape(average(records)),
        tier=html.escape(", ".join(tiers) or "none"),
        look=_look(records, outcome),
        hardest=_hardest(records),
        questions="".join(f"<th>{html.escape(name).replace('.', '.<wbr>')}</th>" for name in questions),
        rows="\n".join(_row(record, questions) for record in records),
        alike=_alike(records),
    )


def _look(records: Sequence[Record], outcome: Outcome) -> str:
    """Return the students who need the teacher's attention, with the reason; the most urgent first."""
    rows = []
    for record in sorted(records, key=lambda each: LOOK.index(each.status()) if each.status() in LOOK else len(LOOK)):
        concerns = record.marked().concerns
        if record.status() in LOOK or concerns:
            late = [f"{verdict.name}: its time was over" for verdict in record.marked().verdicts if verdict.timed_out]
            faulty = [f"{verdict.name}: its check has a fault" for verdict in record.marked().verdicts if verdict.fault]
            why = [*record.handed.open, *faulty, *late, *concerns, *record.marked().notes][:12]
            words = "<br>".join(_text(word) for word in why)
            status = f"<td class='words status'>{record.status()}</td>"
            rows.append(f"<tr><td>{_link(record)}</td>{status}<td class='words'>{words}</td></tr>")
    for _, question in outcome.collection.whose:
        rows.append(f"<tr><td>?</td><td class='words'>question</td><td class='words'>{_text(question.about)}</td></tr>")
    heading = "<tr><th>student</th><th class='words'>status</th><th class='words'>why</th></tr>"
    asked = "<p>Answer the questions in <code>questions.csv</code>, next to the table, and run the command again.</p>"
    how = asked if outcome.collection.unanswered else ""
    return f"<h2>Needs a look</h2>{how}<table>{heading}{''.join(rows)}</table>" if rows else ""


def _hardest(records: Sequence[Record]) -> str:
    """Return the exercises by lost points, with the most frequent wrong answers."""
    verdicts: dict[str, list[Verdict]] = {}
    for record in records:
        for verdict in record.marked().verdicts if record.counts() else ():
            verdicts.setdefault(verdict.name, []).append(verdict)
    share = shares(records)
    rows = []
    for name in sorted(share, key=lambda each: (share[each], each)):
        wrong = Counter(
            as_typed(shown(lost.gave, 160)) or shown(lost.got, 160)
            for lost in verdicts[name]
            if not lost.passed and (lost.gave or lost.got)
        )
        said = "<br>".join(f"{times} × {html.escape(text)}" for text, times in wrong.most_common(3))
        title = html.escape(verdicts[name][0].title)
        what = f"<td>{html.escape(name)} {title}</td><td>{100 * share[name]:.0f} %</td>"
        rows.append(f"<tr>{what}<td class='words'>{said}</td></tr>")
    heading = "<tr><th>exercise</th><th>share of the points</th><th class='words'>most frequent wrong answers</th></tr>"
    said = "<p>Shares are before lateness, of the students that the average is of.</p>"
    return f"<h2>Exercises, the hardest first</h2>{said}<table class='wrap'>{heading}{''.join(rows)}</table>" if rows else ""


def as_typed(answer: str) -> str:
    """Format a value as the student typed it: texts without Python's quotes, lists as their parts.

    >>> as_typed("['topic list', 'node info /talker']"), as_typed("'/scan'"), as_typed("(1, 2.5)"), as_typed("a list: [3]")
    ('topic list | node info /talker', '/scan', '(1, 2.5)', 'a list: 3')
    >>> as_typed("['topic list', 'node inf…")
    'topic list | …'
    """
    kind, colon, said = answer.partition(": ")
    if colon and re.fullmatch(r"an? \w+", kind):
        return f"{kind}: {as_typed(said)}"
    whole = re.sub(r",[^,]*…$", "]", answer) if answer.startswith("[") else answer
    try:
        value = ast.literal_eval(whole)
    except (ValueError, SyntaxError, MemoryError, RecursionError):
        return answer
    if isinstance(value, list) and value:
        parts = [item if isinstance(item, str) else repr(item) for item in value]
        return " | ".join(parts if whole == answer else [*parts, "…"])
    return value if isinstance(value, str) and value.strip() else answer


def _row(record: Record, questions: Sequence[str]) -> str:
    marked, total = record.marked(), record.total()
    verdicts = {verdict.name: verdict for verdict in marked.verdicts}
    cells = "".join(_cell(verdicts.get(name) if record.marks else None) for name in questions)
    eye = [f"<span class='eye'>{_text(concern)}</span>" for concern in [*record.handed.open, *marked.concerns]]
    words = "<br>".join([*eye, *(_text(note) for note in marked.notes)])
    late = late_by(marked.minutes_late) if marked.minutes_late else ""
    return (
        f"<tr><td>{_link(record)}</td>{cells}<td><b>{'?' if total is None else number(total)}</b></td>"
        f"<td class='status'>{record.status()}</td><td class='late'>{late}</td><td>{record.told_off()}</td></tr>"
    ) + (f"<tr class='below'><td></td><td class='words' colspan='{len(questions) + 4}'>{words}</td></tr>" if words else "")


def _cell(verdict: Verdict | None) -> str:
    if verdict is None:
        return "<td></td>"
    kind = "all" if verdict.passed else "some" if verdict.points else "none"
    return f"<td class='{kind}' title='{_text(verdict.got or verdict.title)}'>{number(verdict.points)}</td>"


def _text(text: str) -> str:
    return html.escape(shown(text, 400), quote=True)


def _link(record: Record) -> str:
    return f"<a href='{quote(record.key)}.html'>{_text(record.label)}</a>"


def _alike(records: Sequence[Record]) -> str:
    """Return pairs with nearly the same work: hints for the teacher, not a verdict."""
    by_name = {record.label: record for record in records}
    pairs = similar([record.marked() for record in records if record.marks])
    rows = "".join(
        f"<tr><td>{_link(by_name[one])}</td><td class='words'>{_link(by_name[other])}</td><td>{100 * like:.0f} %</td></tr>"
        for one, other, like in pairs[:_MOST]
    )
    more = f"<p>{len(pairs) - _MOST} more are in similar.csv.</p>" if len(pairs) > _MOST else ""
    return f"<h2>Work that is alike</h2><table>{rows}</table>{more}" if pairs else ""


def write_overview(folder: Path, records: Sequence[Record], outcome: Outcome | None = None) -> None:
    """Write class.html."""
    write_whole(folder / "class.html", overview(records, outcome).encode("utf-8", "replace"), parents=True)
