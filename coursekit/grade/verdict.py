"""A check's verdict: points, expected and observed results, and the likely cause; as HTML and as text."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass

from coursekit.words.gettext import gettext

_OURS = ("expected", "likely cause", "hint", "why")
"""The rows with the check's own text; the others are the student's, and shown unchanged."""

_CELL = "padding:1px 0;text-align:left;vertical-align:top"

NO_HINT = -1
"""For an answer of the wrong form, such as a text for a number: the expectation explains it, and no hint applies."""


class CheckFailed(Exception):
    """Ends a check cell that is not solved yet; the verdict above it gives the reason."""

    def _render_traceback_(self) -> list[str]:
        """Return the text that IPython shows instead of a traceback."""
        return [str(self)]


class Wrong(Exception):
    """Raised by a check: the expected and the observed result, and the likely cause."""

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
        """The observation in the trial."""
        self.cause = cause
        self.share = share
        """The fraction of the points that is earned nevertheless, 0 to 1."""
        self.gave = gave
        """The student's own answer: the value of a variable, what a function returned."""
        self.hint = hint
        """The index of the hint for this fault; NO_HINT if there is none; None if unknown."""
        self.timed_out = timed_out
        """Whether a program or function was ended because it exceeded its time."""
        self.at = at
        """The positions of the fault in the last panel of the judge's picture: x and y, in its units."""


class Skipped(Exception):
    """Raised by a check of a voluntary exercise that cannot be judged on this computer, with the reason."""


@dataclass(frozen=True)
class Verdict:
    """The outcome of one check: `got` is the observation in a trial, `gave` the student's own answer."""

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
    """Whether judging stopped early because the work exceeded its time."""
    fault: str = ""
    """The error of the check itself: then the work is not judged, and the student is not to blame."""
    skipped: str = ""
    """Why a voluntary exercise is not judged here."""

    @property
    def passed(self) -> bool:
        """Whether all points were earned; without points, whether nothing was wrong."""
        return self.points >= self.of and not self.fault and bool(self.of or not self.expected)

    def score(self) -> str:
        """Format the points.

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
        """Return the text for a terminal, and for notebooks without a browser.

        >>> print(Verdict("ch02.q1", "Publish", 2, 2).text())
        ✔ ch02.q1 Publish: 2 of 2 points
        """
        mark = "–" if self.skipped else "✔" if self.passed else "✘"
        lines = [f"{mark} {self.name} {gettext(self.title)}: {self.score()}"]
        lines += [f"  {label}: {value}" for label, value in self._rows()]
        return "\n".join(lines)

    def _rows(self) -> list[tuple[str, str]]:
        """Return the lines below the head, in the course's language; the student's answer stays unchanged."""
        if self.skipped:
            return [(gettext("why"), gettext(self.skipped))]
        rows = [(gettext("expected"), gettext(self.expected)), (gettext("you gave"), self.gave)]
        rows += [(gettext("seen"), gettext(self.got)), (gettext("likely cause"), gettext(self.cause))]
        rows += [(gettext("hint"), gettext(self.hint)), (gettext("fault of the check"), self.fault)]
        to_do = gettext("Show this to your teacher: your work is not to blame.")
        rows += [(gettext("what to do"), to_do)] if self.fault else []
        return [(label, value) for label, value in rows if value and not self.passed]

    def html(self, picture: str = "") -> str:
        """Return the HTML for the notebook; `picture` is HTML below the text."""
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
    """Format a number of points.

    >>> points(1), points(2.5)
    ('1 point', '2.5 points')
    """
    return f"{number:g} point{_s(number)}"


def _s(number: float) -> str:
    return "" if number == 1 else "s"


def _as_html(label: str, value: str) -> str:
    """Format a row; in a check's own text, the part between backticks is code."""
    escaped = html.escape(value)
    ours = label in map(gettext, _OURS)
    return re.sub(r"`([^`\n]+)`", r"<code>\1</code>", escaped) if ours else escaped
