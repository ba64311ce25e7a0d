r"""Splitting and joining command lines in the conventions of this system: on Windows a backslash is part of a path."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterable, Mapping

from . import operating_system

_BEFORE_QUOTE = re.compile(r'(\\*)"')
_AT_END = re.compile(r"(\\+)\Z")
_PLAIN = re.compile(r"""[^\s"']+""")
_FOLDER = re.compile(r"(?:[A-Za-z]:(?=[\\/]))?[^;:]+")
"""A folder on Windows, where a drive contains a colon."""


def split_words(text: str) -> list[str]:
    r"""Split a command line; ValueError for an unclosed quotation.

    On Linux and macOS it follows the shell. On Windows it follows the programs' own rules: a backslash is special only
    before a double quote; single quotes group too, as in PowerShell, except after a letter or digit.

    >>> split_words("topic pub /chat std_msgs/msg/String '{data: hello world}'")[-1]
    '{data: hello world}'
    """
    return _split_for_windows(text) if operating_system.WINDOWS else shlex.split(text)


def join_words(words: Iterable[str]) -> str:
    """Join words to a command line.

    >>> join_words(["ros2", "bag", "info", "my bag"])
    "ros2 bag info 'my bag'"
    """
    return " ".join(map(_quoted_for_windows, words)) if operating_system.WINDOWS else shlex.join(words)


def plain_words(text: str) -> list[str]:
    """Return the words of a command line that needs no shell; empty if it needs one, or is malformed.

    >>> plain_words("ros2 topic list | sort"), plain_words("echo 'a | b'")
    ([], ['echo', 'a | b'])
    """
    if any(sign in text for sign in ("%^\n" if operating_system.WINDOWS else "$`\n\\")):
        return []
    try:
        words = split_words(text) if operating_system.WINDOWS else list(_with_operators(text))
    except ValueError:
        return []
    return [] if any(word and set(word) <= set("();<>|&") for word in words) else words


def split_folders(text: str) -> list[str]:
    """Split a path list that was joined by a package, without empty parts.

    Launch files written on Linux join with a colon, on every system: on Windows both separators count.

    >>> split_folders("/opt/models:/home/vera/models:")
    ['/opt/models', '/home/vera/models']
    """
    return _FOLDER.findall(text) if operating_system.WINDOWS else [word for word in text.split(":") if word]


def _with_operators(text: str) -> shlex.shlex:
    reader = shlex.shlex(text, posix=True, punctuation_chars=True)
    reader.whitespace_split = True
    return reader


def shell_command(text: str, env: Mapping[str, str]) -> list[str]:
    """Return the command that runs a text in this user's shell.

    >>> shell_command("echo $HOME", {"SHELL": "/bin/bash"})
    ['/bin/bash', '-c', 'echo $HOME']
    """
    if operating_system.WINDOWS:
        return [env.get("COMSPEC") or "cmd.exe", "/d", "/c", *split_words(text)]
    return [env.get("SHELL") or "/bin/sh", "-c", text]


def _quoted_for_windows(word: str) -> str:
    if _PLAIN.fullmatch(word):
        return word
    return '"' + _AT_END.sub(r"\1\1", _BEFORE_QUOTE.sub(r'\1\1\\"', word)) + '"'


def _split_for_windows(text: str) -> list[str]:
    words: list[str] = []
    word: str | None = None
    inside = ""
    for piece in re.findall(r"""\\*"|'|\s|\\+|[^\s\\"']+""", text):
        slashes, quote = len(piece) - 1, piece[-1]
        if quote == '"' and inside != "'":
            word = (word or "") + "\\" * (slashes // 2)
            if slashes % 2:
                word += '"'
            else:
                inside = "" if inside else '"'
        elif quote == "'" and (inside == "'" or not (inside or (word or "")[-1:].isalnum())):
            word, inside = word or "", "" if inside else "'"
        elif piece.isspace() and not inside:
            words += [] if word is None else [word]
            word = None
        else:
            word = (word or "") + piece
    if inside:
        raise ValueError("No closing quotation")
    return words if word is None else [*words, word]
