"""A student's points over the course, in one small file in the course folder."""

from __future__ import annotations

import json
import os
from html import escape
from pathlib import Path
from typing import Any

from coursekit.files import write_whole
from coursekit.words.gettext import gettext

from .exercise import all_exercises
from .verdict import Verdict


class Progress:
    """Best points, tries and hints by exercise."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.only = ""
        self._kept: dict[str, dict[str, float]] = self._read()

    @classmethod
    def of_course(cls) -> Progress:
        """Return the progress stored in the current course folder."""
        return cls(Path(os.environ.get("COURSEKIT_COURSE", ".")) / ".coursekit" / "progress.json")

    def _read(self) -> dict[str, dict[str, float]]:
        try:
            content = json.loads(self.file.read_text(encoding="utf-8"))
        except (OSError, ValueError):
            return {}
        return content if isinstance(content, dict) else {}

    def _change(self, name: str, key: str, value: float) -> None:
        self._kept.setdefault(name, {})[key] = value
        write_whole(self.file, json.dumps(self._kept, indent=1, sort_keys=True), parents=True)

    def _count(self, name: str, key: str) -> int:
        number = int(self._kept.get(name, {}).get(key, 0)) + 1
        self._change(name, key, number)
        return number

    def count_try(self, name: str) -> int:
        """Count a try. Returns its number."""
        return self._count(name, "tries")

    def count_hint(self, name: str) -> int:
        """Count a hint. Returns its number."""
        return self._count(name, "hints")

    def note(self, verdict: Verdict) -> None:
        """Store the points if they are the best so far."""
        if verdict.points >= self.points(verdict.name):
            self._change(verdict.name, "points", verdict.points)
        if verdict.passed:
            self._change(verdict.name, "tries", 0)
        if verdict.passed and not verdict.skipped:
            self._change(verdict.name, "done", 1)

    def points(self, name: str) -> float:
        """Return the best points for an exercise so far."""
        return float(self._kept.get(name, {}).get("points", 0))

    def chapters(self) -> dict[str, tuple[float, float, list[tuple[str, str, float, float]]]]:
        """Return points, maximum and (name, title, points, of) of the exercises for each chapter.

        A completed voluntary exercise has 1 of 0 points.
        """
        chapters: dict[str, Any] = {}
        for name, exercise in all_exercises().items():
            if not name.startswith(self.only):
                continue
            points, of, rows = chapters.get(name.partition(".")[0], (0.0, 0.0, []))
            got = self.points(name)
            done = float(self._kept.get(name, {}).get("done", 0))
            rows.append((name, exercise.title, got if exercise.points else done, exercise.points))
            chapters[name.partition(".")[0]] = (points + got, of + exercise.points, rows)
        return chapters

    def __repr__(self) -> str:
        lines = [gettext("chapter  points")]
        for chapter, (points, of, _) in self.chapters().items():
            full = round(20 * points / of) if of else 0
            lines.append(f"{chapter:<8} {points:>4g} {gettext('of')} {of:<4g} {'█' * full}{'·' * (20 - full)}")
        return "\n".join(lines)

    def _repr_html_(self) -> str:
        rows = []
        for chapter, (points, of, exercises) in self.chapters().items():
            marks = "".join(
                f"<span title='{_told(name, title, got, most)}' style='display:inline-block;width:12px;height:12px;"
                f"margin-right:3px;border-radius:3px;background:{_colour(got, most)}'>"
                "</span>"
                for name, title, got, most in exercises
            )
            rows.append(
                f"<tr><td style='text-align:left'>{escape(chapter)}</td><td>{gettext(f'{points:g} of {of:g}')}</td>"
                f"<td style='text-align:left'>{marks}</td></tr>"
            )
        heads = "".join(f"<th>{heading}</th>" for heading in (gettext("chapter"), gettext("points"), gettext("exercises")))
        return f"<table><tr>{heads}</tr>{''.join(rows)}</table>"


def _told(name: str, title: str, got: float, most: float) -> str:
    voluntary = gettext("done (no points)") if got else gettext("not done (no points)")
    score = gettext(f"{got:g} of {most:g}") if most else voluntary
    return escape(f"{name} {gettext(title)}: {score}", quote=False)


def _colour(got: float, most: float) -> str:
    """Return green for all points, yellow for some, grey for none."""
    return "#1a7f4b" if got and got >= most else "#c9a13b" if got else "#c8ced3"


def progress(chapter: str = "") -> Progress:
    """Show the student's progress over the whole course, or over one chapter ("ch02")."""
    progress = Progress.of_course()
    progress.only = chapter
    return progress
