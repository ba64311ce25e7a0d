"""The front end of a widget as one text: shared files, its own file, and the overlay for an ended program."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from pathlib import Path

from coursekit.words.gettext import language, words_of

_STATIC = Path(__file__).parent / "static"
_EXPORT = "export default {"
_SAID = re.compile(r'\bgettext\(("(?:[^"\\]|\\.)*")')


def script(*names: str) -> str:
    """Concatenate files of `static/`. The last one exports the widget; an overlay covers it when its program is gone."""
    before, veil, *parts = ((_STATIC / name).read_text(encoding="utf-8") for name in ("gettext.js", "veil.js", *names))
    own = "\n".join(parts)
    assert own.count(_EXPORT) == 1, f"{names[-1]} has to export one widget: {_EXPORT} ... }};"
    whole = f"{before}\n{veil}\n{own.replace(_EXPORT, 'const widget = {')}\nexport default veiled(widget);\n"
    return f"const WORDS = {json.dumps(_words(whole), ensure_ascii=False)};\n{whole}"


def said_in(source: str) -> Iterator[str]:
    """Return the translatable texts of a script, in English.

    >>> list(said_in('title: gettext("look from \\\\"{0}\\\\"", one)'))
    ['look from "{0}"']
    """
    return map(json.loads, _SAID.findall(source))


def _words(source: str) -> dict[str, str]:
    """Return the texts of a script in the course's language; empty for English."""
    known = words_of(language()).by_english
    return {text: known[text] for text in said_in(source) if text in known}


def style(*names: str) -> str:
    """Concatenate style sheets of `static/`."""
    return "\n".join((_STATIC / name).read_text(encoding="utf-8") for name in names)


__all__ = ["said_in", "script", "style"]
