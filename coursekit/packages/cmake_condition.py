"""Conditions of if() and elseif()."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from pathlib import Path

_FALSE = ("", "0", "OFF", "NO", "FALSE", "N", "IGNORE", "NOTFOUND")
_TRUE = ("1", "ON", "YES", "TRUE", "Y")


def _version(text: str) -> list[int]:
    return [int(part) for part in re.findall(r"\d+", text)]


_BINARY: dict[str, Callable[[str, str], bool]] = {
    "STREQUAL": str.__eq__,
    "EQUAL": str.__eq__,
    "MATCHES": lambda text, pattern: re.search(pattern, text) is not None,
    "LESS": lambda a, b: _version(a) < _version(b),
    "GREATER": lambda a, b: _version(a) > _version(b),
    "VERSION_LESS": lambda a, b: _version(a) < _version(b),
    "VERSION_GREATER": lambda a, b: _version(a) > _version(b),
    "VERSION_EQUAL": lambda a, b: _version(a) == _version(b),
    "VERSION_GREATER_EQUAL": lambda a, b: _version(a) >= _version(b),
    "VERSION_LESS_EQUAL": lambda a, b: _version(a) <= _version(b),
}


def holds(words: list[str], variables: Mapping[str, str]) -> bool:
    """Return whether a condition holds; a name that is not set is false.

    >>> holds(['NOT', 'BUILD_TESTING', 'AND', 'X', 'STREQUAL', 'a'], {'BUILD_TESTING': 'OFF', 'X': 'a'})
    True
    """
    return _Condition(words, variables).either()


class _Condition:
    def __init__(self, words: list[str], variables: Mapping[str, str]) -> None:
        self.words, self.variables, self.index = words, variables, 0

    def next(self) -> str:
        self.index += 1
        return self.words[self.index - 1] if self.index <= len(self.words) else ""

    def peek(self) -> str:
        return self.words[self.index] if self.index < len(self.words) else ""

    def either(self) -> bool:
        result = self.both()
        while self.peek() == "OR":
            self.next()
            result = self.both() or result
        return result

    def both(self) -> bool:
        result = self.one()
        while self.peek() == "AND":
            self.next()
            result = self.one() and result
        return result

    def one(self) -> bool:
        word = self.next()
        if word == "NOT":
            return not self.one()
        if word == "(":
            result = self.either()
            self.next()
            return result
        if word == "DEFINED":
            return self.next() in self.variables
        if word in ("EXISTS", "IS_DIRECTORY"):
            return Path(self.next()).exists()
        if word in ("TARGET", "COMMAND", "POLICY", "TEST"):
            self.next()
            return False
        if self.peek() in _BINARY:
            compare = _BINARY[self.next()]
            return compare(self.value(word), self.value(self.next()))
        return self.truth(word)

    def value(self, word: str) -> str:
        return self.variables.get(word, word)

    def truth(self, word: str) -> bool:
        if word.upper() in _TRUE:
            return True
        value = self.variables.get(word, "")
        return value.upper() not in _FALSE and not value.upper().endswith("-NOTFOUND")
