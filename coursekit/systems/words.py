r"""Command lines to words and back, as people of this system write them: on Windows a backslash is part of a path."""

from __future__ import annotations

import re
import shlex
from collections.abc import Iterable, Mapping

from . import which

_BEFORE_QUOTE = re.compile(r'(\\*)"')
_AT_END = re.compile(r"(\\+)\Z")
_PLAIN = re.compile(r"""[^\s"']+""")
_FOLDER = re.compile(r"(?:[A-Za-z]:(?=[\\/]))?[^;:]+")
"""On Windows, where a drive has a colon."""


def split_words(text: str) -> list[str]:
    r"""The words of a command line; ValueError when a quotation does not end.

    On Linux and macOS as the shell has them. On Windows as programs there read their command line, a backslash counting
    only before a double quote; single quotes group too, as in PowerShell, except after a letter or digit.

    >>> split_words("topic pub /chat std_msgs/msg/String '{data: hello world}'")[-1]
    '{data: hello world}'
    """
    return _split_for_windows(text) if which.WINDOWS else shlex.split(text)


def join_words(words: Iterable[str]) -> str:
    """The command line whose words these are.

    >>> join_words(["ros2", "bag", "info", "my bag"])
    "ros2 bag info 'my bag'"
    """
    return " ".join(map(_quoted_for_windows, words)) if which.WINDOWS else shlex.join(words)


def plain_words(text: str) -> list[str]:
    """The words of a command line that needs no shell; none when it does, or is not plain.

    >>> plain_words("ros2 topic list | sort"), plain_words("echo 'a | b'")
    ([], ['echo', 'a | b'])
    """
    if any(sign in text for sign in ("%^\n" if which.WINDOWS else "$`\n\\")):
        return []
    try:
        words = split_words(text) if which.WINDOWS else list(_with_operators(text))
    except ValueError:
        return []
    return [] if any(word and set(word) <= set("();<>|&") for word in words) else words


def split_folders(text: str) -> list[str]:
    """The folders of a variable that a package has put together, without empty ones.

    Launch files that were written on Linux join with a colon, on every system: on Windows both separators count.

    >>> split_folders("/opt/models:/home/vera/models:")
    ['/opt/models', '/home/vera/models']
    """
    return _FOLDER.findall(text) if which.WINDOWS else [one for one in text.split(":") if one]


def _with_operators(text: str) -> shlex.shlex:
    reader = shlex.shlex(text, posix=True, punctuation_chars=True)
    reader.whitespace_split = True
    return reader


def shell_command(text: str, env: Mapping[str, str]) -> list[str]:
    """The command that has this user's shell carry out a text.

    >>> shell_command("echo $HOME", {"SHELL": "/bin/bash"})
    ['/bin/bash', '-c', 'echo $HOME']
    """
    if which.WINDOWS:
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
