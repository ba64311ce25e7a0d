"""This computer's time zone for a container, which may lack a time zone database: deadlines without a zone use it."""

from __future__ import annotations

import time

DAY = 86400


def posix_zone(when: float) -> str:
    """Return the zone in POSIX format, with the daylight saving changes in the year of `when`.

    Europe/Berlin in 2026 is `<+0100>-01:00<+0200>-02:00,J88/02:00,J298/03:00`.
    """
    year = time.localtime(when).tm_year
    begin = int(time.mktime((year, 1, 1, 12, 0, 0, 0, 0, -1)))
    days = range(begin, begin + 365 * DAY, DAY)
    changes = [_change(day) for day in days if _offset(day) != _offset(day + DAY)]
    summer = [change for change in changes if time.localtime(change).tm_isdst == 1]
    winter = [change for change in changes if time.localtime(change).tm_isdst == 0]
    if len(changes) != 2 or len(summer) != 1 or len(winter) != 1:
        return _named(_offset(int(when)))
    usual, other = _offset(winter[0]), _offset(summer[0])
    return f"{_named(usual)}{_named(other)},{_rule(summer[0], usual)},{_rule(winter[0], other)}"


def _offset(when: int) -> int:
    """Return the offset in seconds east of Greenwich."""
    return time.localtime(when).tm_gmtoff


def _change(day: int) -> int:
    """Return the time within a day at which the offset changes."""
    low, high = day, day + DAY
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (middle, high) if _offset(middle) == _offset(day) else (low, middle)
    return high


def _named(offset: int) -> str:
    """Return an offset's name and value: POSIX counts westwards."""
    hours, minutes = divmod(abs(offset) // 60, 60)
    east = offset >= 0
    return f"<{'+' if east else '-'}{hours:02}{minutes:02}>{'-' if east else ''}{hours:02}:{minutes:02}"


def _rule(when: int, before: int) -> str:
    """Return the day of the year without February 29, and the local time before the change."""
    told = time.gmtime(when + before)
    leap = told.tm_year % 4 == 0 and (told.tm_year % 100 != 0 or told.tm_year % 400 == 0)
    day = told.tm_yday - (1 if leap and told.tm_yday > 59 else 0)
    return f"J{day}/{told.tm_hour:02}:{told.tm_min:02}"
