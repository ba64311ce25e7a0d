"""Texts from students made harmless: for a terminal, a page, a table cell or a file name."""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterable

LONGEST = 200
"""The maximum length of a displayed text from outside [characters]."""
_JOINERS = "\u200c\u200d"
"""Format characters required in names, by Persian and Indian scripts."""
_FORMULA = re.compile(r"""(^|[;,"|\n])([ \u00a0']*)([=+\-@\uff1d\uff0b\uff0d\uff20])""")


def shown(text: str, most: int = LONGEST) -> str:
    r"""Make a text safe to display: no control characters, no marks that change the writing direction.

    >>> shown("Ann\x1b[2J\u202eeeL\n")
    'Ann [2JeeL'
    """
    kept = "".join(_letter(letter) for letter in text[: 4 * most])
    kept = " ".join(unicodedata.normalize("NFC", kept).split())
    return kept if len(kept) <= most else kept[: most - 1] + "…"


def _letter(letter: str) -> str:
    kind = unicodedata.category(letter)
    if kind in ("Cc", "Zl", "Zp"):
        return " "
    if kind == "Cs":
        return "\ufffd"
    return "" if kind in ("Cf", "Co", "Cn") and letter not in _JOINERS else letter


def cell(text: str, most: int = 2000) -> str:
    """Make a text safe for a CSV cell: no spreadsheet reads it, or a part of it, as a formula.

    A quotation mark or a semicolon may end a cell when other separators are used, so the text after it is escaped
    too.

    >>> cell("=1+1"), cell("Ann;=cmd()"), cell('x"\\t@SUM(1)'), cell("a-b, c")
    ("'=1+1", "Ann;'=cmd()", 'x" \\'@SUM(1)', 'a-b, c')
    """
    return _FORMULA.sub(r"\1\2'\3", shown(text, most))


def lines(text: str, most: int = 400) -> str:
    r"""Return a text of several lines without invisible characters.

    >>> lines("seen\u202e\x1b[2J\n\tagain")
    'seen [2J\n    again'
    """
    kept = text.expandtabs(4).splitlines()[:most]
    return "\n".join("".join(_letter(letter) for letter in line[:400]) for line in kept)


def number(value: float) -> str:
    """Format points for tables.

    >>> number(2.0), number(1.25)
    ('2', '1.25')
    """
    return f"{value:.10g}"


def identity_of(text: str) -> str:
    """Normalise a name for comparison: it ignores the form and case of letters, and separators.

    >>> identity_of("Ann_Lee") == identity_of("ann  lee"), identity_of("José") == identity_of("Jose")
    (True, False)
    """
    return re.sub(r"[\W_]+", " ", unicodedata.normalize("NFKC", text).casefold()).strip()


def name_of_files(identity: str, name: str = "") -> str:
    """Return the name of a person's files: a readable part and a digest, unique on every file system.

    >>> name_of_files("class")
    'class-0889113e'
    """
    plain = unicodedata.normalize("NFKD", name or identity).encode("ascii", "ignore").decode().casefold()
    slug = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:40].strip("-")
    return f"{slug or 'student'}-{hashlib.sha256(identity.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}"


def unique(texts: Iterable[str]) -> list[str]:
    """Return each text once, in the order of first occurrence.

    >>> unique(["b", "a", "b"])
    ['b', 'a']
    """
    return list(dict.fromkeys(texts))
