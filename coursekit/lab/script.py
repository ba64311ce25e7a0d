"""The browser's side of a widget, as one text: what several share, its own, and the veil over what has ended."""

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
    """The files of `static/` one after the other; the last exports the widget, which is veiled when its program is gone."""
    before, veil, *parts = ((_STATIC / name).read_text(encoding="utf-8") for name in ("gettext.js", "veil.js", *names))
    own = "\n".join(parts)
    assert own.count(_EXPORT) == 1, f"{names[-1]} has to export one widget: {_EXPORT} ... }};"
    whole = f"{before}\n{veil}\n{own.replace(_EXPORT, 'const widget = {')}\nexport default veiled(widget);\n"
    return f"const WORDS = {json.dumps(_words(whole), ensure_ascii=False)};\n{whole}"


def said_in(source: str) -> Iterator[str]:
    """The words that a script says, in English.

    >>> list(said_in('title: gettext("look from \\\\"{0}\\\\"", one)'))
    ['look from "{0}"']
    """
    return map(json.loads, _SAID.findall(source))


def _words(source: str) -> dict[str, str]:
    """The words that a script says, in the course's language; none where that is English."""
    known = words_of(language()).by_english
    return {text: known[text] for text in said_in(source) if text in known}


def style(*names: str) -> str:
    """The style sheets of `static/` one after the other."""
    return "\n".join((_STATIC / name).read_text(encoding="utf-8") for name in names)


__all__ = ["said_in", "script", "style"]
