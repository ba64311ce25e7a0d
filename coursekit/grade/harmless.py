"""Texts that students chose, made harmless: for a terminal, for a page, for a cell of a table, for the name of a file."""

from __future__ import annotations

import hashlib
import re
import unicodedata
from collections.abc import Iterable

LONGEST = 200
"""Letters of a text from outside that are shown."""
_JOINERS = "\u200c\u200d"
"""Format characters that names need: Persian and Indian scripts are written with them."""
_FORMULA = re.compile(r"""(^|[;,"|\n])([ \u00a0']*)([=+\-@\uff1d\uff0b\uff0d\uff20])""")


def shown(text: str, most: int = LONGEST) -> str:
    r"""A text that changes nothing but its own place: no control characters, no marks that turn the direction of writing.

    >>> shown("Ann\x1b[2J\u202eeeL\n")
    'Ann [2JeeL'
    """
    kept = "".join(_letter(one) for one in text[: 4 * most])
    kept = " ".join(unicodedata.normalize("NFC", kept).split())
    return kept if len(kept) <= most else kept[: most - 1] + "…"


def _letter(one: str) -> str:
    kind = unicodedata.category(one)
    if kind in ("Cc", "Zl", "Zp"):
        return " "
    if kind == "Cs":
        return "\ufffd"
    return "" if kind in ("Cf", "Co", "Cn") and one not in _JOINERS else one


def cell(text: str, most: int = 2000) -> str:
    """A text for a cell of a CSV table: no spreadsheet takes it, or a part of it, for a formula.

    A quotation mark or a semicolon may end a cell where the table is opened with other separators: what follows counts too.

    >>> cell("=1+1"), cell("Ann;=cmd()"), cell('x"\\t@SUM(1)'), cell("a-b, c")
    ("'=1+1", "Ann;'=cmd()", 'x" \\'@SUM(1)', 'a-b, c')
    """
    return _FORMULA.sub(r"\1\2'\3", shown(text, most))


def lines(text: str, most: int = 400) -> str:
    """A text of several lines, as it is but for invisible signs."""
    kept = text.expandtabs(4).splitlines()[:most]
    return "\n".join("".join(_letter(letter) for letter in line[:400]) for line in kept)


def number(value: float) -> str:
    """Points as written in tables.

    >>> number(2.0), number(1.25)
    ('2', '1.25')
    """
    return f"{value:.10g}"


def identity_of(text: str) -> str:
    """The part of a name that tells it from others: letters, not their form, their case, or signs between them.

    >>> identity_of("Ann_Lee") == identity_of("ann  lee"), identity_of("José") == identity_of("Jose")
    (True, False)
    """
    return re.sub(r"[\W_]+", " ", unicodedata.normalize("NFKC", text).casefold()).strip()


def name_of_files(identity: str, name: str = "") -> str:
    """The name of a person's files: letters to read and a digest; no two people's collide, on no file system.

    >>> name_of_files("class")
    'class-0889113e'
    """
    plain = unicodedata.normalize("NFKD", name or identity).encode("ascii", "ignore").decode().casefold()
    slug = re.sub(r"[^a-z0-9]+", "-", plain).strip("-")[:40].strip("-")
    return f"{slug or 'student'}-{hashlib.sha256(identity.encode('utf-8', 'surrogatepass')).hexdigest()[:8]}"


def unique(texts: Iterable[str]) -> list[str]:
    """Each text once, in the order in which they came."""
    return list(dict.fromkeys(texts))
