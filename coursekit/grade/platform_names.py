"""The file names in learning platforms' downloads of a class's submissions."""

from __future__ import annotations

import calendar
import re
import time
from dataclasses import dataclass

_MOODLE = re.compile(r"(?P<name>.+?)_(?P<number>\d+)_assignsubmission_(?:file|onlinetext)(?:_(?P<file>.*))?", re.S)
_CANVAS = re.compile(r"(?P<name>[^_]+)(?:_(?P<late>LATE))?_(?P<number>\d+)_(?P<attempt>\d+)_(?P<file>.+)", re.S)
_BLACKBOARD = re.compile(
    r"(?P<before>.+?)_attempt_(?P<when>\d{4}-\d\d-\d\d-\d\d-\d\d-\d\d)(?:_(?P<file>.+)|\.txt)?", re.S
)
_NBGRADER = re.compile(
    r"(?P<login>[^+]+)\+(?P<release>[^+]+)\+(?P<when>\d{4}-\d\d-\d\d \d\d:\d\d:\d\d)(?:\.\d+)? (?P<zone>\w+)(?:\+.*)?", re.S
)
_CLASSROOM = re.compile(r"(?P<name>.+?) - (?P<file>.+)", re.S)


@dataclass(frozen=True)
class PlatformName:
    """The parts of a file or folder name in a download."""

    platform: str
    name: str = ""
    """The person's name in the platform's spelling."""
    number: str = ""
    """The platform's identifier of the person."""
    logins: tuple[str, ...] = ()
    """The possible logins: a login may also contain the separator."""
    file: str = ""
    """The student's file name."""
    when: float = 0.0
    """The submission time in seconds since 1970; 0 if the name has none."""
    late: bool = False
    """Whether the platform marked it as late."""


def platform_name(text: str) -> PlatformName | None:
    """Parse a name in a download; None when it is not in a platform's format.

    >>> platform_name("García López Ana_101_assignsubmission_file_").number
    '101'
    >>> found = platform_name("itoben_LATE_12_13_02_topics.ipynb"); found.name, found.late, found.file
    ('itoben', True, '02_topics.ipynb')
    >>> platform_name("ben+week2+2026-11-22 23:59:00.000001 UTC+Xy").when
    1795391940.0
    >>> platform_name("Ann_Lee") is None
    True
    """
    if match := _NBGRADER.fullmatch(text):
        name = match["login"].strip()
        return PlatformName("nbgrader", name, "", (name,), match["release"], _time(match["when"], match["zone"]))
    if match := _MOODLE.fullmatch(text):
        return PlatformName("moodle", match["name"].strip(), match["number"], file=match["file"] or "")
    if match := _BLACKBOARD.fullmatch(text):
        words = match["before"].split("_")
        logins = tuple("_".join(words[-count:]) for count in range(1, len(words)))
        return PlatformName("blackboard", "", "", logins or (match["before"],), match["file"] or "", _time(match["when"]))
    if match := _CANVAS.fullmatch(text):
        return PlatformName("canvas", match["name"], match["number"], file=match["file"], late=bool(match["late"]))
    if match := _CLASSROOM.fullmatch(text):
        return PlatformName("classroom", match["name"].strip(), file=match["file"])
    return None


def moodle_folder(name: str, number: str) -> str:
    """Return the folder name by which Moodle assigns files to a participant.

    >>> platform_name(moodle_folder("Ann Lee", "101")).number
    '101'
    """
    return f"{name.replace('_', ' ')}_{number}_assignsubmission_file_"


def _time(text: str, zone: str = "") -> float:
    try:
        read = time.strptime(text.replace(" ", "-").replace(":", "-"), "%Y-%m-%d-%H-%M-%S")
        return float(calendar.timegm(read)) if zone == "UTC" else time.mktime(read)
    except (ValueError, OverflowError):
        return 0.0
