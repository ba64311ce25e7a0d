"""A check's verdict: points, expected and seen, the likely cause; as HTML and as text."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass

from coursekit.words.gettext import gettext

_OURS = ("expected", "likely cause", "hint", "why")
"""The rows that are a check's own words; the others are the student's, and shown as they are."""

_CELL = "padding:1px 0;text-align:left;vertical-align:top"

NO_HINT = -1
"""Of an answer whose form is wrong, such as a text for a number: what was expected says it, and no hint is about that."""


class CheckFailed(Exception):
    """Ends a check cell that is not solved yet; the verdict above it says why."""

    def _render_traceback_(self) -> list[str]:
        """IPython shows this instead of a traceback."""
        return [str(self)]


class Wrong(Exception):
    """Raised by a check: what was expected, what was seen, and the likely cause."""

    def __init__(
        self,
        expected: str,
        got: str = "",
        cause: str = "",
        *,
        share: float = 0.0,
        gave: str = "",
        hint: int | None = None,
        timed_out: bool = False,
        at: Sequence[Sequence[float]] = (),
    ) -> None:
        super().__init__(expected)
        self.expected = expected
        self.got = got
        """The observation when the work was tried out."""
        self.cause = cause
        self.share = share
        """The part of the points that is earned all the same, 0 to 1."""
        self.gave = gave
        """The student's own answer: the value of a variable, what a function returned."""
        self.hint = hint
        """Which of the exercise's hints fits this fault, from 0; NO_HINT if none does; None where that cannot be told."""
        self.timed_out = timed_out
        """Whether a program or function was ended because its time was over."""
        self.at = at
        """Where the fault is in the last panel of the picture that the judge handed out: x and y, in its units."""


class Skipped(Exception):
    """Raised by a check of a voluntary exercise: why it cannot be judged on this computer."""


@dataclass(frozen=True)
class Verdict:
    """The outcome of one check: `got` is what was seen in a trial, `gave` the student's own answer."""

    name: str
    title: str
    points: float
    of: float
    expected: str = ""
    got: str = ""
    cause: str = ""
    hint: str = ""
    gave: str = ""
    timed_out: bool = False
    """Whether the work was not judged to the end because its time was over."""
    fault: str = ""
    """The error of the check itself: then the work is not judged, and its author is not to blame."""
    skipped: str = ""
    """Why a voluntary exercise is not judged here."""

    @property
    def passed(self) -> bool:
        """Whether all points were earned; without points, whether nothing was wrong."""
        return self.points >= self.of and not self.fault and bool(self.of or not self.expected)

    def score(self) -> str:
        """The points in words.

        >>> Verdict("ch02.q1", "Publish", 1, 2).score()
        '1 of 2 points'
        >>> Verdict("ch02.q5", "Publish in C++", 0, 0).score()
        'done (no points)'
        """
        if self.fault:
            return gettext("not judged")
        if self.skipped:
            return gettext("skipped")
        if not self.of:
            return gettext("done (no points)") if self.passed else gettext("not done (no points)")
        return gettext(f"{self.points:g} of {self.of:g} point{_s(self.of)}")

    def text(self) -> str:
        """For a terminal, and for notebooks without a browser.

        >>> print(Verdict("ch02.q1", "Publish", 2, 2).text())
        ✔ ch02.q1 Publish: 2 of 2 points
        """
        mark = "–" if self.skipped else "✔" if self.passed else "✘"
        lines = [f"{mark} {self.name} {gettext(self.title)}: {self.score()}"]
        lines += [f"  {label}: {value}" for label, value in self._rows()]
        return "\n".join(lines)

    def _rows(self) -> list[tuple[str, str]]:
        """The lines below the head, in the course's language; what the student gave stays as it is."""
        if self.skipped:
            return [(gettext("why"), gettext(self.skipped))]
        rows = [(gettext("expected"), gettext(self.expected)), (gettext("you gave"), self.gave)]
        rows += [(gettext("seen"), gettext(self.got)), (gettext("likely cause"), gettext(self.cause))]
        rows += [(gettext("hint"), gettext(self.hint)), (gettext("fault of the check"), self.fault)]
        to_do = gettext("Show this to your teacher: your work is not to blame.")
        rows += [(gettext("what to do"), to_do)] if self.fault else []
        return [(label, value) for label, value in rows if value and not self.passed]

    def html(self, picture: str = "") -> str:
        """For the notebook; `picture` is HTML below the words."""
        colour, mark = ("var(--right, #1a7f4b)", "✔") if self.passed else ("var(--wrong, #b3392f)", "✘")
        if self.skipped:
            colour, mark = "var(--muted, #5c6b76)", "–"
        rows = "".join(
            f"<tr style='background:none'><td style='{_CELL};opacity:.7;padding-right:12px;white-space:nowrap'>{label}</td>"
            f"<td style='{_CELL};white-space:pre-wrap'>{_as_html(label, value)}</td></tr>"
            for label, value in self._rows()
        )
        number, _, rest = self.score().partition(" ") if self.of and not self.fault else (self.score(), "", "")
        table = f"<table style='margin:4px 0 0 0'>{rows}</table>" if rows else ""
        return (
            f"<div style='border-left:4px solid {colour};padding:6px 12px;margin:4px 0'>"
            f"<b style='color:{colour}'>{mark} {html.escape(self.name)}</b> {html.escape(gettext(self.title))}: "
            f"<b>{number}</b> {rest}{table}{picture}</div>"
        )


def points(number: float) -> str:
    """A number of points in words.

    >>> points(1), points(2.5)
    ('1 point', '2.5 points')
    """
    return f"{number:g} point{_s(number)}"


def _s(number: float) -> str:
    return "" if number == 1 else "s"


def _as_html(label: str, value: str) -> str:
    """In a check's own words, the part between backticks is code."""
    escaped = html.escape(value)
    ours = label in map(gettext, _OURS)
    return re.sub(r"`([^`\n]+)`", r"<code>\1</code>", escaped) if ours else escaped
