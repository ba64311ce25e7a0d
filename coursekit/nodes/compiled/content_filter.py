"""Content filters of subscriptions: DDS expressions such as `data < %0 OR data > %1` select messages."""

from __future__ import annotations

import re
from collections.abc import Callable
from operator import eq, ge, gt, le, lt, ne
from typing import Any

_WORD = re.compile(
    r"""\s*(?:(?P<text>'(?:[^']|'')*')|(?P<number>[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)|%(?P<parameter>\d+)
    |(?P<name>[A-Za-z_]\w*(?:\[\d+\])?(?:\.[A-Za-z_]\w*(?:\[\d+\])?)*)|(?P<sign><>|!=|<=|>=|=|<|>|\(|\)))""",
    re.VERBOSE,
)
_COMPARE: dict[str, Callable[[Any, Any], Any]] = {"=": eq, "<>": ne, "!=": ne, "<": lt, "<=": le, ">": gt, ">=": ge}
_KEYWORDS = {"AND", "OR", "NOT", "BETWEEN", "LIKE", "MATCH", "TRUE", "FALSE"}
_LIMIT = 100
"""The maximum number of parameters of one expression in DDS."""
Test = Callable[[Any], bool]
Value = Callable[[Any], Any]


class FilterError(ValueError):
    """An expression that DDS would reject."""


def compile_filter(expression: str, parameters: list[str]) -> Test:
    """Return the function that decides whether a message passes. FilterError for an invalid expression.

    >>> from std_msgs.msg import Int32
    >>> test = compile_filter("data BETWEEN %0 AND %1 OR data = -1", ["3", "5"])
    >>> [test(Int32(data=number)) for number in (2, 3, 5, 6, -1)]
    [False, True, True, False, True]
    """
    if len(parameters) > _LIMIT:
        raise FilterError(f"There are {len(parameters)} parameters; {_LIMIT} are allowed.")
    reader = _Reader(_words(expression), parameters)
    test = reader.either()
    reader.expect_end()
    return test


def _words(expression: str) -> list[tuple[str, str]]:
    """Return the tokens of an expression with their kinds."""
    words, at = [], 0
    text = expression.rstrip()
    while at < len(text):
        match = _WORD.match(text, at)
        if match is None:
            raise FilterError(f"'{expression}' cannot be read from its character {at + 1} on.")
        kind = str(match.lastgroup)
        word = match.group(kind)
        if kind == "name" and word.upper() in _KEYWORDS:
            kind, word = "keyword", word.upper()
        words.append((kind, word))
        at = match.end()
    return words


class _Reader:
    """Parses tokens from left to right; AND binds more tightly than OR."""

    def __init__(self, words: list[tuple[str, str]], parameters: list[str]) -> None:
        self._words = words
        self._parameters = parameters

    def expect_end(self) -> None:
        """Raise FilterError if tokens are left."""
        if self._words:
            raise FilterError(f"'{self._words[0][1]}' is not expected there.")

    def either(self) -> Test:
        """Parse conditions joined by OR."""
        tests = [self._all()]
        while self._next_is("OR"):
            tests.append(self._all())
        return tests[0] if len(tests) == 1 else lambda message: any(test(message) for test in tests)

    def _all(self) -> Test:
        tests = [self._one()]
        while self._next_is("AND"):
            tests.append(self._one())
        return tests[0] if len(tests) == 1 else lambda message: all(test(message) for test in tests)

    def _one(self) -> Test:
        if self._next_is("NOT"):
            denied = self._one()
            return lambda message: not denied(message)
        if self._next_is("("):
            inner = self.either()
            self._demand(")")
            return inner
        return self._condition()

    def _condition(self) -> Test:
        left = self._value()
        denied = self._next_is("NOT")
        if self._next_is("BETWEEN"):
            low = self._value()
            self._demand("AND")
            high = self._value()
            return lambda message: (low(message) <= left(message) <= high(message)) != denied
        if self._next_is("LIKE"):
            pattern = self._value()
            return lambda message: _like(left(message), pattern(message)) != denied
        if self._next_is("MATCH"):
            expression = self._value()
            return lambda message: _match(left(message), expression(message)) != denied
        kind, word = self._take()
        if denied or kind != "sign" or word not in _COMPARE:
            raise FilterError(f"'{word}' is no comparison.")
        compare, right = _COMPARE[word], self._value()
        return lambda message: bool(compare(left(message), right(message)))

    def _value(self) -> Value:
        kind, word = self._take()
        if kind == "parameter":
            if int(word) >= len(self._parameters):
                raise FilterError(f"There is no parameter %{word}.")
            kind, word = _literal(self._parameters[int(word)])
        if kind == "name":
            return _field(word)
        value = _constant(kind, word)
        return lambda _message: value

    def _take(self) -> tuple[str, str]:
        if not self._words:
            raise FilterError("The expression ends too early.")
        return self._words.pop(0)

    def _next_is(self, wanted: str) -> bool:
        if self._words and self._words[0][1] == wanted and self._words[0][0] in ("keyword", "sign"):
            self._words.pop(0)
            return True
        return False

    def _demand(self, wanted: str) -> None:
        if not self._next_is(wanted):
            raise FilterError(f"There should be {wanted}.")


def _literal(text: str) -> tuple[str, str]:
    """Return a parameter's value as a token; only constants are allowed."""
    words = _words(text)
    if len(words) != 1 or words[0][0] not in ("text", "number", "keyword"):
        raise FilterError(f"The parameter {text!r} is no number and no text in quotes.")
    return words[0]


def _constant(kind: str, word: str) -> Any:
    if kind == "text":
        return word[1:-1].replace("''", "'")
    if kind == "number":
        return float(word) if set(word) & set(".eE") else int(word)
    if word in ("TRUE", "FALSE"):
        return word == "TRUE"
    raise FilterError(f"'{word}' is no value.")


def _field(path: str) -> Value:
    """Return the function that reads a field such as `header.stamp.sec` or `ranges[3]`."""
    steps = re.findall(r"[A-Za-z_]\w*|\[\d+\]", path)

    def read(message: Any) -> Any:
        for step in steps:
            message = message[int(step[1:-1])] if step.startswith("[") else getattr(message, step)
        return message

    return read


def _like(text: str, pattern: str) -> bool:
    """Whether a text matches a pattern, in which % matches any characters and _ one character."""
    parts = [".*" if letter in "%*" else "." if letter in "_?" else re.escape(letter) for letter in pattern]
    return re.fullmatch("".join(parts), text, re.DOTALL) is not None


def _match(text: str, expression: str) -> bool:
    """Whether a regular expression describes the whole text; False where it is none."""
    try:
        return re.fullmatch(expression, text) is not None
    except re.error:
        return False
