"""The pages of the class and of each student, with shortcuts and input fields beside verdicts; input is saved at once."""

from __future__ import annotations

import html
from collections.abc import Mapping
from pathlib import Path
from urllib.parse import quote

from coursekit.grade.record import COMMENT, ON_EXERCISE, Record
from coursekit.grade.report import page
from coursekit.grade.sanitizing import number

from .marks import Marks

STATIC = Path(__file__).with_name("static")
_HEAD = """<link rel="icon" href="data:,"><link rel="stylesheet" href="static/review.css">
<script defer src="static/review.js"></script>"""
_BAR = """<nav><a id="class" href="class.html">The class</a><span>{at} of {all}</span>
<a id="before" href="{before}">Before</a>
<a id="next" href="{next}">Next</a><span id="saved" role="status"></span>
<span class="keys"><kbd>j</kbd> <kbd>k</kbd> student <kbd>n</kbd> <kbd>p</kbd> exercise <kbd>c</kbd> comment
<kbd>Enter</kbd> save, next <kbd>Esc</kbd> leave the field <kbd>u</kbd> the class</span></nav>"""
_CLASS_BAR = """<nav><b>Marking by hand</b><span class="keys"><kbd>j</kbd> <kbd>k</kbd> student <kbd>Enter</kbd> open; then
<kbd>n</kbd> <kbd>p</kbd> exercise <kbd>c</kbd> comment <kbd>Enter</kbd> save, next <kbd>u</kbd> back to here</span></nav>"""
_FIELDS = """<form class="marks" data-exercise="{name}">
<label>Points <input name="points" inputmode="decimal" autocomplete="off" value="{points}"
placeholder="{given}"> of {of}</label>
<label>Comment <textarea name="comment" rows="2">{comment}</textarea></label></form>"""
_WHOLE = """<form class="marks" data-exercise="">
<label>Comment on all of it <textarea name="comment" rows="3">{comment}</textarea></label></form>"""


def class_page(marks: Marks) -> str:
    """Return the current page of the class, with the shortcuts."""
    content = marks.class_page()
    return _with(content, {"</head>": f"{_HEAD}</head>", "<body>": f'<body class="reviewing">{_CLASS_BAR}'})


def marking_page(marks: Marks, key: str) -> str:
    """Return the page for marking a person."""
    record, order = marks.records[key], list(marks.order())
    at = order.index(key) if key in order else 0
    content = page(record, lambda name: _fields(record, name))
    before, after = order[at - 1] if at else "", order[at + 1] if at + 1 < len(order) else ""
    links = {"before": f"{quote(before)}.html" if before else "#", "next": f"{quote(after)}.html" if after else "#"}
    bar = _BAR.format(at=at + 1, all=len(order), **links)
    whole = _WHOLE.format(comment=html.escape(record.extra.get(COMMENT, "")))
    body = f'<body data-key="{html.escape(key)}">{bar}'
    places = {"</head>": f"{_HEAD}</head>", "<body>": body, "</footer>": f"</footer>{whole}"}
    return _with(content, places)


def _with(page: str, places: Mapping[str, str]) -> str:
    for place, text in places.items():
        page = page.replace(place, text, 1)
    return page


def _fields(record: Record, name: str) -> str:
    """Return the fields for points and comment of an exercise; empty points keep the grader's."""
    verdict = next(candidate for candidate in record.marked().verdicts if candidate.name == name)
    own = next((v.points for m in record.marks.values() for v in m.verdicts if v.name == name), 0.0)
    return _FIELDS.format(
        name=html.escape(name, quote=True),
        points=number(record.by_hand[name]) if name in record.by_hand else "",
        given=number(own),
        of=number(verdict.of),
        comment=html.escape(record.extra.get(name + ON_EXERCISE, "")),
    )
