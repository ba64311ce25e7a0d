"""`gettext("Trying out ch02.q1")`: translate a sentence to the course's language.

English is the key, and is shown if there is no translation.
An entry of the catalogue may have fields, `{0} m from a side`: it matches every sentence with any text in the fields.
So code produces its sentences in English, and the display translates each as a whole.
"""

from __future__ import annotations

import contextlib
import functools
import os
import re
from collections.abc import Iterator
from contextvars import ContextVar
from pathlib import Path

ENGLISH = "en"
LANGUAGE = "COURSEKIT_LANGUAGE"
"""The environment variable with the language code."""
FIELD = re.compile(r"\{(\d+)\}")
_LONGEST_CODE, _LONGEST = 8, 500
"""Maximum length of a language code; and of a sentence: a longer one contains student text, and is shown untranslated."""
_DEEPEST = 3
"""Maximum nesting: the text of a field may itself match an entry with fields."""
_LEAST, _LEAST_INSIDE = 4, 9
"""Minimum number of letters outside of its fields: an entry with fewer would match anything. It is higher for the text of
another entry's field, which may contain output of a student's program."""
_reader: ContextVar[str] = ContextVar("reader", default="")
"""The language of the person addressed; '' for the course's language."""


def language() -> str:
    """Return the code of the course's language, or of the addressed person's language (`speaking`)."""
    return _reader.get() or os.environ.get(LANGUAGE) or ENGLISH


@contextlib.contextmanager
def speaking(code: str) -> Iterator[None]:
    """Use this language inside the block, whatever the course's is: a teacher marks students of several languages.

    An unknown language falls back to English: the code may come from a student's file.

    >>> with speaking("es"):
    ...     print(language())
    es
    """
    before = _reader.set(code if _is_ours(code) else ENGLISH)
    try:
        yield
    finally:
        _reader.reset(before)


def gettext(text: str) -> str:
    """Translate a text to the course's language.

    >>> gettext("No topics: start a node.")
    'No topics: start a node.'
    """
    return words_of(language()).translated(text)


@functools.cache
def words_of(code: str) -> Words:
    """Return the translations to a language; empty for English, and for languages without a catalogue."""
    if not _is_ours(code):
        return Words({})
    import polib

    return Words({entry.msgid: entry.msgstr for entry in polib.pofile(str(catalogue_of(code))).translated_entries()})


def _is_ours(code: str) -> bool:
    """Whether there is a catalogue for this language."""
    return code.isascii() and code.isalpha() and len(code) <= _LONGEST_CODE and catalogue_of(code).is_file()


def catalogue_of(code: str) -> Path:
    """Return a language's catalogue file."""
    return Path(__file__).with_name(f"{code}.po")


class Words:
    """Translations of sentences, keyed by the English text.

    >>> words = Words({"{0} m of line": "{0} m de línea", "none": "ninguno"})
    >>> words.translated("7 m of line"), words.translated("none m of line"), words.translated("else")
    ('7 m de línea', 'ninguno m de línea', 'else')
    """

    def __init__(self, by_english: dict[str, str]) -> None:
        self.by_english = by_english
        with_fields = [text for text in by_english if FIELD.search(text) and _letters(text) >= _LEAST]
        known = sorted(with_fields, key=_letters, reverse=True)
        self._patterns = [(_pattern(text), by_english[text], _letters(text)) for text in known]

    def translated(self, text: str, depth: int = 0) -> str:
        """Return the translation, or the text itself if there is none; of several matches the most specific."""
        if text in self.by_english:
            return self.by_english[text]
        if len(text) > _LONGEST or depth > _DEEPEST:
            return text
        for pattern, other, letters in self._patterns:
            if (letters >= _LEAST_INSIDE or not depth) and (match := pattern.fullmatch(text)):
                return FIELD.sub(lambda field: self.translated(match[int(field[1]) + 1], depth + 1), other)
        return text


def _letters(text: str) -> int:
    return sum(letter.isalpha() for letter in FIELD.sub("", text))


def _pattern(text: str) -> re.Pattern[str]:
    return re.compile("(.*?)".join(re.escape(part) for part in FIELD.split(text)[::2]), re.S)
