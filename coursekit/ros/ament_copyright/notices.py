"""Copyright notices and licenses in the comments of a source file."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache

from coursekit.words import licenses

UNKNOWN = "<unknown>"
LICENSES = {
    "apache2": "Apache License, Version 2.0",
    "boost1": "Boost Software License - Version 1.0",
    "bsd2": "BSD License 2.0",
    "bsd_2clause": "2-Clause BSD License",
    "bsd_3clause": "3-Clause BSD License",
    "gplv3": "GNU General Public License 3.0",
    "lgplv3": "GNU Lesser General Public License 3.0",
    "mit": "MIT License",
    "mit0": "MIT-0 License",
}
_FILES = {"mit": "MIT", "mit0": "MIT-0", "boost1": "BSL-1.0", "bsd_3clause": "BSD-3-Clause", "bsd_2clause": "BSD-2-Clause"}
"""The licenses whose notice is their whole text. bsd2 has the text of bsd_2clause and is reported by that name."""
_YEARS = r"\d{4}(?:-\d{4})?(?:,\s*\d{4}(?:-\d{4})?)*"
_COPYRIGHT = re.compile(rf"^.?\s*(?:\\copyright\s*)?copyright(?:\s+\(c\))?\s+({_YEARS}),?\s+(\S.*)$", re.I | re.M)
_BULLET = re.compile(r"(?<!\S)(?:[*-]|\(?\d[.)])\s")
_HOLDER = re.compile(r"(?<=name of )the copyright holder|(?<=names of )its")
_LINES = re.compile(r"^(#|///?)(.*(?:\n\1.*)*)", re.M)
_BLOCK = re.compile(r"^/\*(.*?)\*/$|^<!--(.*?)-->$", re.M | re.S)


@dataclass(frozen=True)
class Notice:
    """The copyright holders of a file, such as 'Vera Course (2020)', and the short name of its license."""

    holders: list[str]
    license: str


def notice_of(text: str) -> Notice | None:
    """The notice in a file's text, None if there is none.

    >>> notice_of("# Copyright (c) 2019-2021, Vera Course\\n# All rights reserved.\\nx = 1\\n")
    Notice(holders=['Vera Course (2019-2021)'], license='<unknown>')
    """
    holders, license_ = [], UNKNOWN
    for comment in _comments(text):
        notices = list(_COPYRIGHT.finditer(comment))
        holders += [f"{notice[2]} ({notice[1]})" for notice in notices]
        if license_ == UNKNOWN:
            license_ = license_of(comment[notices[-1].end() :] if notices else comment)
    return Notice(holders, license_) if holders else None


def license_of(text: str) -> str:
    """The short name of the license that a text contains."""
    words = _words(text)
    for name, sections in _sections().items():
        places = [words.find(section) for section in sections]
        if -1 not in places and places == sorted(places):
            return name
    return UNKNOWN


def _comments(text: str) -> Iterator[str]:
    """Yield the comments that begin at the start of a line, without comment markers."""
    for match in _LINES.finditer(text):
        mark = match[1]
        yield "\n".join(line[len(mark) + 1 :] for line in match[0].splitlines())
    for match in _BLOCK.finditer(text):
        lines = (match[1] or match[2] or "").splitlines()
        lines = lines[1:-1] if len(lines) > 2 else lines[-1:]
        yield "\n".join(re.sub(r"^\s*\*? ?", "", line) for line in lines) if len(lines) > 1 else "".join(lines)


def _words(text: str) -> str:
    """A text on one line, without the bullets and numbers of its lists."""
    return _BULLET.sub("", " ".join(text.split()))


def _text(name: str) -> str:
    return licenses.text(name) or ""


@cache
def _sections() -> dict[str, list[str]]:
    """The parts of the comment of each license, in order."""
    texts = {"apache2": _text("Apache-2.0").rpartition("[name of copyright owner]")[2]}
    gnu = _text("GPL-3.0-only").rpartition("    This program is free software")[2].partition("If not, see")[0]
    texts["gplv3"] = "This program is free software" + gnu
    texts["lgplv3"] = texts["gplv3"].replace("GNU General", "GNU Lesser General")
    texts |= {name: _text(file) for name, file in _FILES.items()}
    return {name: [holder for holder in map(_words, _HOLDER.split(text)) if holder] for name, text in texts.items()}
