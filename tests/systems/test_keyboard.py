"""Keys of Windows' console come through as a terminal of Linux sends them, and lines stay lines until keys are wanted."""

import os
import sys

import pytest

from coursekit.systems import console, keyboard
from coursekit.systems.keyboard import Keyboard


class Console:
    """msvcrt, as somebody types; after the last key nothing comes any more."""

    def __init__(self) -> None:
        self.typed: list[str] = []

    def kbhit(self) -> bool:
        if not self.typed:
            raise KeyboardInterrupt
        return True

    def getwch(self) -> str:
        return self.typed.pop(0)


@pytest.fixture
def typed(monkeypatch):
    """What is still to be typed at a console that has this test's standard input."""
    fake_console, (read, write) = Console(), os.pipe()
    os.write(write, b"a line\n")
    monkeypatch.setattr(console, "_msvcrt", lambda: fake_console)
    monkeypatch.setattr(console, "is_there", lambda number: True)
    monkeypatch.setattr(keyboard, "termios", None)
    with os.fdopen(read, encoding="utf-8") as stdin:
        monkeypatch.setattr(sys, "stdin", stdin)
        yield fake_console.typed
    os.close(write)


def test_a_line_is_read_whole_while_no_keys_are_wanted(typed):
    typed += "a"
    with Keyboard() as ours:
        assert ours.read() == b"a line\n"


@pytest.mark.parametrize(
    ("keys", "sent"),
    [("w", b"w"), ("\r", b"\n"), ("\xe0H", b"\x1b[A"), ("\0K", b"\x1b[D"), ("ñ", "ñ".encode()), ("\0;x", b"x")],
)
def test_a_key_comes_at_once_and_as_linux_sends_it(typed, keys, sent):
    typed += keys
    with Keyboard() as ours:
        ours.want_keys()
        assert ours.read() == sent


def test_ctrl_c_ends_the_wait_for_a_key(typed):
    with Keyboard() as ours, pytest.raises(KeyboardInterrupt):
        ours.want_keys()
        ours.read()
