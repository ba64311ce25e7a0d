"""`gettext("Trying out ch02.q1")`: a sentence in the course's language.

English is the key, and is shown where nothing is translated.

A catalogue's entry may have fields, `{0} m from a side`: it stands for every sentence that has something at those places.
So what says a sentence makes it in English, and where it is shown it is translated as a whole.
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
"""The variable of the environment that names the language by its code."""
FIELD = re.compile(r"\{(\d+)\}")
_LONGEST_CODE, _LONGEST = 8, 500
"""Letters of a language's code; and of a sentence: a longer one holds something of the student's, and is shown as it is."""
_DEEPEST = 3
"""A field's own words may have fields again."""
_LEAST, _LEAST_INSIDE = 4, 9
"""Letters outside of its fields that an entry needs, or it would stand for anything; more within another's field, which may
hold what a student's program said."""
_reader: ContextVar[str] = ContextVar("reader", default="")
"""The language of whom something is written for; '' where it is the course's."""


def language() -> str:
    """The code of the course's language, or of the reader's where something is written for one (`speaking`)."""
    return _reader.get() or os.environ.get(LANGUAGE) or ENGLISH


@contextlib.contextmanager
def speaking(code: str) -> Iterator[None]:
    """Have what is said inside be in this language, whatever the course's is: a teacher marks for students of several.

    What is no language of ours is English: the code may come from a file of a student's.

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
    """The text in the course's language.

    >>> gettext("No topics: start a node.")
    'No topics: start a node.'
    """
    return words_of(language()).translated(text)


@functools.cache
def words_of(code: str) -> Words:
    """The translations into a language; none for English, and for languages that nobody has translated the course into."""
    if not _is_ours(code):
        return Words({})
    import polib

    return Words({one.msgid: one.msgstr for one in polib.pofile(str(catalogue_of(code))).translated_entries()})


def _is_ours(code: str) -> bool:
    """Whether there is a catalogue for a language."""
    return code.isascii() and code.isalpha() and len(code) <= _LONGEST_CODE and catalogue_of(code).is_file()


def catalogue_of(code: str) -> Path:
    """The file of a language's words."""
    return Path(__file__).with_name(f"{code}.po")


class Words:
    """Translations of sentences, by their English.

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
        """The sentence, or itself where there is no translation; of several entries the one that says most."""
        if text in self.by_english:
            return self.by_english[text]
        if len(text) > _LONGEST or depth > _DEEPEST:
            return text
        for pattern, other, letters in self._patterns:
            if (letters >= _LEAST_INSIDE or not depth) and (found := pattern.fullmatch(text)):
                return FIELD.sub(lambda field: self.translated(found[int(field[1]) + 1], depth + 1), other)
        return text


def _letters(text: str) -> int:
    return sum(letter.isalpha() for letter in FIELD.sub("", text))


def _pattern(text: str) -> re.Pattern[str]:
    return re.compile("(.*?)".join(re.escape(part) for part in FIELD.split(text)[::2]), re.S)
