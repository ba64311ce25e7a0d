"""Parses CMakeLists.txt to a list of commands, without interpreting them."""

from __future__ import annotations

import re
from dataclasses import dataclass
from pathlib import Path

from coursekit.files import read_text

_TOKEN = re.compile(
    r"""
    (?P<space>[ \t\r\n]+)
  | (?P<block_comment>\#\[(?P<ce>=*)\[.*?\](?P=ce)\])
  | (?P<comment>\#[^\n]*)
  | (?P<bracket>\[(?P<be>=*)\[\n?(?P<raw>.*?)\](?P=be)\])
  | "(?P<quoted>(?:\\.|[^"\\])*)"
  | (?P<paren>[()])
  | (?P<word>(?:\\.|\$\{[^}]*\}|\$ENV\{[^}]*\}|"(?:\\.|[^"\\])*"|[^\s()#"\\])+)
    """,
    re.VERBOSE | re.DOTALL,
)


class CMakeError(ValueError):
    """A CMakeLists.txt that cannot be parsed or executed; carries file and line."""

    def __init__(self, message: str, file: Path, line: int) -> None:
        super().__init__(f"{file}:{line}: {message}")
        self.message, self.file, self.line = message, file, line


@dataclass(frozen=True)
class Argument:
    """One argument; a quoted one is not split, even when it is empty or contains ';'."""

    text: str
    quoted: bool = False


@dataclass(frozen=True)
class Command:
    """`name(arguments)`; the name is in lower case."""

    name: str
    arguments: tuple[Argument, ...]
    file: Path
    line: int

    def error(self, message: str) -> CMakeError:
        """Return an error with the location of this command."""
        return CMakeError(message, self.file, self.line)


def read_commands(file: Path) -> list[Command]:
    """Return the commands of a CMakeLists.txt; raises CMakeError for invalid text."""
    return parse_commands(read_text(file, errors="replace"), file)


def parse_commands(text: str, file: Path = Path("CMakeLists.txt")) -> list[Command]:
    """Return the commands of a text.

    >>> parse_commands('project(a) # comment')[0].arguments
    (Argument(text='a', quoted=False),)
    """
    tokens = _tokens(text, file)
    commands, index = [], 0
    while index < len(tokens):
        kind, name, line = tokens[index]
        if kind != "word" or index + 1 >= len(tokens) or tokens[index + 1][:2] != ("paren", "("):
            raise CMakeError(f"expected a command such as project(...), not '{name}'", file, line)
        arguments, index = _arguments(tokens, index + 2, file, line)
        commands.append(Command(name.lower(), arguments, file, line))
    return commands


def _tokens(text: str, file: Path) -> list[tuple[str, str, int]]:
    tokens, position = [], 0
    while position < len(text):
        line = text.count("\n", 0, position) + 1
        match = _TOKEN.match(text, position)
        if match is None:
            raise CMakeError(f"cannot read '{text[position : position + 20].splitlines()[0]}'", file, line)
        position = match.end()
        if match["raw"] is not None:
            tokens.append(("quoted", match["raw"], line))
        elif match["quoted"] is not None:
            tokens.append(("quoted", re.sub(r"\\(.)", r"\1", match["quoted"]), line))
        elif match["paren"] or match["word"]:
            tokens.append(("paren" if match["paren"] else "word", match[0], line))
    return tokens


def _arguments(tokens: list[tuple[str, str, int]], index: int, file: Path, line: int) -> tuple[tuple[Argument, ...], int]:
    arguments: list[Argument] = []
    depth = 1
    while index < len(tokens):
        kind, text, _ = tokens[index]
        index += 1
        if kind == "paren":
            depth += 1 if text == "(" else -1
            if depth == 0:
                return tuple(arguments), index
        arguments.append(Argument(text, kind == "quoted"))
    raise CMakeError("this command has no closing ')'", file, line)
