"""What a test needs of the system, and how paths are spelled on it."""

from __future__ import annotations

import os
import stat
import sys
from pathlib import Path

import pytest

from coursekit.cpp.toolchain import NoToolchain, Toolchain, find_toolchain

ON_WINDOWS = sys.platform == "win32"


def posix(why: str) -> pytest.MarkDecorator:
    """The mark of a test that looks at what Windows does not have; `why` says what."""
    return pytest.mark.skipif(ON_WINDOWS, reason=f"Windows: {why}")


def real_windows(why: str) -> pytest.MarkDecorator:
    """The mark of a test that Wine cannot run, while Windows may; `why` says what Wine lacks."""
    return pytest.mark.skipif(in_wine(), reason=f"Wine: {why}")


def in_wine() -> bool:
    """Whether this Windows is Wine."""
    if not ON_WINDOWS:
        return False
    import ctypes

    return hasattr(ctypes.windll.ntdll, "wine_get_version")  # type: ignore[attr-defined]


def compiler_or_skip() -> Toolchain:
    """What compiles C++ here; the test is skipped where nothing does."""
    if ON_WINDOWS:
        pytest.skip("Windows: C++ is not compiled there yet")
    try:
        return find_toolchain()
    except NoToolchain as error:
        pytest.skip(str(error))


def can_compile() -> bool:
    """Whether something compiles C++ here."""
    try:
        return bool(find_toolchain())
    except NoToolchain:
        return False


def is_private(file: Path) -> bool:
    """Whether its owner alone may read a file; Windows has no such modes, there it lies in a folder of the user's."""
    return ON_WINDOWS or stat.S_IMODE(file.stat().st_mode) == 0o600


def slashed(text: str | Path) -> str:
    r"""A text with paths as it is on Linux: a test compares what is said, not how this system spells folders.

    >>> slashed(Path("install") / "setup.py")
    'install/setup.py'
    """
    return str(text).replace(os.sep, "/")


__all__ = ["ON_WINDOWS", "can_compile", "compiler_or_skip", "in_wine", "posix", "real_windows", "slashed"]
