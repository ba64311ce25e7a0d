"""The parser of text that contains `$(name arguments)`."""

from __future__ import annotations

import re
from typing import Any

from ..substitution import Substitution
from .expose import instantiate_substitution

QUOTES = ("'", '"')
NAME = re.compile(r"[A-Za-z0-9_-]+")


class InvalidSubstitution(ValueError):
    """Raised if a `$(...)` is not closed or has no name; the message points at the position."""


def replace_escaped_characters(data: str) -> str:
    r"""Return the text with each backslash removed from the character after it.

    >>> replace_escaped_characters(r'a\$b')
    'a$b'
    """
    return re.sub(r"\\(.)", r"\1", data)


def parse_substitution(string_value: str) -> list[Substitution]:
    """Parse the text into a list of substitutions.

    >>> parse_substitution('speed_$(var unit)')[1].describe()
    "LaunchConfig('unit')"

    Raises:
        InvalidSubstitution: if a `$(` is not closed.
        RuntimeError: for an unknown substitution.
    """
    return _Reader(string_value).template("")


def parse_if_substitutions(value: Any) -> Any:
    """Return `value` with the text in it parsed; text without substitutions stays text.

    Raises:
        ValueError: if a list contains items of different types.
    """
    if isinstance(value, list):
        items = [_parse_one(item) for item in value]
        if len({type(item) for item in items if not isinstance(item, list)}) > 1:
            raise ValueError("The result is a non-uniform list")
        return items
    return _parse_one(value)


def _parse_one(value: Any) -> Any:
    if not isinstance(value, str):
        return value
    parsed = parse_substitution(value)
    if len(parsed) == 1 and hasattr(parsed[0], "text"):
        return parsed[0].text
    return parsed


class _Reader:
    """Reads one text from left to right."""

    def __init__(self, text: str) -> None:
        self.text = text
        self.at = 0

    def template(self, stop: str, inside: str = "") -> list[Substitution]:
        """Read text and substitutions up to one of the characters in `stop`, or to the end.

        `inside` is the open quote, if any.
        """
        substitutions: list[Substitution] = []
        plain = ""
        while self.at < len(self.text) and self.text[self.at] not in stop:
            if self.text.startswith("$(", self.at):
                if plain:
                    substitutions.append(_plain(plain))
                    plain = ""
                substitutions.append(self.substitution(inside))
            else:
                plain += self.piece()
        if plain or not substitutions:
            substitutions.append(_plain(plain))
        return substitutions

    def piece(self) -> str:
        """Read one character, or a backslash and the one after it."""
        length = 2 if self.text[self.at] == "\\" else 1
        piece = self.text[self.at : self.at + length]
        self.at += length
        return piece

    def substitution(self, inside: str) -> Substitution:
        """Read `$(name arguments)`; `inside` a quote, quotes are ordinary characters."""
        start = self.at
        self.at += 2
        self.skip_space()
        name = NAME.match(self.text, self.at)
        if name is None:
            raise self.error("a name is missing after $(", self.at)
        self.at = name.end()
        arguments = []
        while self.skip_space() and not self.text.startswith(")", self.at):
            arguments.append(self.argument(inside))
        if self.at >= len(self.text):
            raise self.error("$( is not closed", start)
        self.at += 1
        return instantiate_substitution(name.group(), *arguments)

    def argument(self, inside: str) -> list[Substitution]:
        """Read one argument, optionally in quotes."""
        quote = self.text[self.at]
        start = self.at
        if inside and quote == inside:
            raise self.error("$( is not closed before the quote", start)
        if inside or quote not in QUOTES:
            return self.template(" \t\n\r)" + inside, inside)
        self.at += 1
        argument = self.template(quote, quote)
        if self.at >= len(self.text):
            raise self.error(f"the quote {quote} is not closed", start)
        self.at += 1
        return argument

    def skip_space(self) -> bool:
        """Skip white space; return whether any text is left."""
        while self.at < len(self.text) and self.text[self.at].isspace():
            self.at += 1
        return self.at < len(self.text)

    def error(self, what: str, at: int) -> InvalidSubstitution:
        """Return an error that points at a character."""
        return InvalidSubstitution(f"{what}:\n  '{self.text}'\n   {' ' * at}^")


def _plain(text: str) -> Substitution:
    from ..substitutions.text_substitution import TextSubstitution

    return TextSubstitution(text=replace_escaped_characters(text))
