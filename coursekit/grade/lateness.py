"""Deadlines, extensions and penalties for late work, from a small file written by the teacher.

```toml
due = 2026-11-30T23:59:00     # --due on the command line takes precedence, with a message
grace_minutes = 10
percent_per_day = 10          # of the points, for each day begun
floor_percent = 50            # the minimum left, however late it is
[extensions]                  # by id, e-mail or name: another deadline, or additional days
"a01234" = 2026-12-02T23:59:00
"ben@uni.example" = 3
```

A `.csv` with the columns `student` and `due` (a time, or additional days) contains only extensions.
"""

from __future__ import annotations

import datetime
import math
import re
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from coursekit.words.gettext import gettext

from .roster import Person, Roster
from .sanitizing import identity_of
from .tables import decoded, read_table

DAY_S = 86400.0
_KNOWN = ("due", "grace_minutes", "percent_per_day", "floor_percent", "extensions", "count")
_MINUTES = re.compile(r"(=[ \t]*\d{4}-\d\d-\d\d[T ]\d\d:\d\d)(?=[ \t]*(?:#.*)?$)", re.M)
"""A time without seconds, allowed only since TOML 1.1."""
_FORMS = (
    "%A, %d %B %Y, %I:%M %p", "%A, %d %B %Y, %H:%M", "%d %B %Y, %I:%M %p", "%d/%m/%Y %H:%M", "%Y-%m-%d %H:%M:%S %z",
    "%Y-%m-%d %H:%M:%S UTC", "%b %d, %Y, %I:%M %p", "%B %d, %Y %I:%M %p",
)  # fmt: skip


@dataclass(frozen=True)
class Policy:
    """The rules for late work."""

    due: float | None = None
    """In seconds since 1970; None when there is no deadline."""
    grace_minutes: float = 0.0
    percent_per_day: float = 0.0
    floor_percent: float = 0.0
    extensions: Mapping[str, float] = field(default_factory=dict)
    """Individual deadlines by identity, in seconds since 1970."""
    days_more: Mapping[str, float] = field(default_factory=dict)
    count: str = "newest"
    told: tuple[str, ...] = ()
    """Messages about rules of the file overridden by the command line."""

    def instead(self, due: float | None, count: str | None, file: Path | None) -> Policy:
        """Apply the command line's rules; overridden rules of the file are reported."""
        policy, told = self, []
        if due is not None and due != self.due:
            if self.due is not None:
                said = f"The deadline {_told(due)} of --due counts; not that of {file}, {_told(self.due)}."
                told.append(f"{said} Its other lines hold.")
            policy = replace(policy, due=due)
        if count is not None and count != self.count:
            if file is not None:
                told.append(f"'{count}' of --count counts; not '{self.count}' of {file}.")
            policy = replace(policy, count=count)
        return replace(policy, told=tuple(told))

    def own_due(self, person: Person) -> float | None:
        """Return a person's due time, without grace."""
        if person.identity in self.extensions:
            return self.extensions[person.identity]
        if self.due is None:
            return None
        return self.due + DAY_S * self.days_more.get(person.identity, 0.0)

    def deadline(self, person: Person) -> float | None:
        """Return the time until which work is not late."""
        due = self.own_due(person)
        return None if due is None else due + 60 * self.grace_minutes

    def minutes_late(self, person: Person, when: float) -> float:
        """Return the minutes after the deadline; 0 within the grace period."""
        due, deadline = self.own_due(person), self.deadline(person)
        if due is None or deadline is None or when <= deadline:
            return 0.0
        return round((when - due) / 60, 1)

    def percent_off(self, minutes: float) -> float:
        """Return the percentage deducted for lateness.

        >>> Policy(percent_per_day=10, floor_percent=75).percent_off(2000), Policy(percent_per_day=10).percent_off(0)
        (20.0, 0.0)
        """
        days = math.ceil(minutes / 1440)
        return float(min(100 - self.floor_percent, self.percent_per_day * days)) if minutes > 0 else 0.0


def read_policy(file: Path, roster: Roster | None) -> Policy:
    """Read the policy from a file.

    Raises:
        ValueError: when it contains an unknown word, time or student.
    """
    if file.suffix.casefold() == ".csv":
        due_by_student = {row.get("student", ""): row.get("due", "") for row in read_table(file).dicts()}
        return _extended(Policy(), due_by_student, roster, file)
    tomllib: Any
    if sys.version_info >= (3, 11):
        import tomllib
    else:
        import tomli as tomllib
    try:
        said = tomllib.loads(_MINUTES.sub(r"\1:00", decoded(file.read_bytes())))
    except tomllib.TOMLDecodeError as error:
        raise ValueError(f"{file}: {error}") from None
    unknown = set(said) - set(_KNOWN)
    if unknown:
        raise ValueError(f"{file}: '{min(unknown)}' is not known. There are: {', '.join(_KNOWN)}.")
    due = said.pop("due", None)
    extensions = said.pop("extensions", {})
    for name, value in said.items():
        most = 100.0 if name.endswith(("_percent", "percent_per_day")) else 1e9
        if name != "count" and not (type(value) in (int, float) and 0 <= value <= most):
            to = " to 100" if most == 100 else " or more"
            raise ValueError(f"{file}: {name} has to be a number, 0{to}, not {value!r}.")
    if said.get("count", "newest") not in ("newest", "in-time"):
        raise ValueError(f"{file}: count is 'newest' or 'in-time', not {said['count']!r}.")
    policy = replace(Policy(), due=None if due is None else _seconds(due, file), **said)
    return _extended(policy, extensions, roster, file)


def _extended(policy: Policy, said: Mapping[str, Any], roster: Roster | None, file: Path) -> Policy:
    times, days = {}, {}
    for name, value in said.items():
        person = roster.of(name) if roster else Person(name, id=identity_of(name))
        if person is None:
            raise ValueError(f"{file}: '{name}' is no student in the list, or more than one. Give the id.")
        if type(value) in (int, float) or str(value).replace(".", "", 1).isdecimal():
            days[person.identity] = _days(float(value), name, file)
        else:
            times[person.identity] = _seconds(value, file)
    return replace(policy, extensions=times, days_more=days)


def _days(value: float, name: str, file: Path) -> float:
    if not abs(value) < 10_000:
        raise ValueError(f"{file}: '{name}' cannot have {value} days more.")
    return value


def _seconds(value: Any, file: Path) -> float:
    try:
        return (value if isinstance(value, datetime.datetime) else due_time(str(value))).timestamp()
    except (ValueError, OverflowError) as error:
        raise ValueError(f"{file}: {error}") from None


def due_time(text: str) -> datetime.datetime:
    """Parse a due time; a day without a time means its end.

    Raises:
        ValueError: when it is not a time.

    >>> due_time("2026-11-30").isoformat(), due_time("2026-11-30T12:00").isoformat()
    ('2026-11-30T23:59:59', '2026-11-30T12:00:00')
    """
    try:
        due = datetime.datetime.fromisoformat(text.strip())
        day = re.fullmatch(r"\d{4}-\d\d-\d\d", text.strip()) is not None
    except ValueError:
        raise ValueError(f"'{text}' is no time. Write it as 2026-11-30T23:59.") from None
    return due.replace(hour=23, minute=59, second=59) if day else due


def platform_time(text: str) -> float:
    """Parse the time in a platform's list, in seconds since 1970; 0 when there is none.

    >>> platform_time("Monday, 23 November 2026, 11:59 PM") > 0, platform_time("-")
    (True, 0.0)
    """
    try:
        return datetime.datetime.fromisoformat(text.strip().replace("Z", "+00:00")).timestamp()
    except (ValueError, OverflowError):
        pass
    for form in _FORMS:
        try:
            moment = datetime.datetime.strptime(text.strip(), form)
        except ValueError:
            continue
        return (moment.replace(tzinfo=datetime.timezone.utc) if form.endswith("UTC") else moment).timestamp()
    return 0.0


def _told(when: float) -> str:
    return time.strftime("%Y-%m-%d %H:%M", time.localtime(when))


def late_by(minutes: float) -> str:
    """Format a lateness for people.

    >>> late_by(1411), late_by(3 * 1440 + 61)
    ('23 h 31 min', '3 days 1 h')
    """
    whole = max(1, int(minutes))
    days, hours, left = whole // 1440, whole % 1440 // 60, whole % 60
    told = gettext("1 day") if days == 1 else gettext(f"{days} days")
    parts = [told if days else "", f"{hours} h" if hours else "", f"{left} min" if left and not days else ""]
    return " ".join(part for part in parts if part)
