"""Helpers for importing compiled modules and, on Windows, the libraries that they need."""

from __future__ import annotations

import contextlib
import importlib
from collections.abc import Iterator
from types import ModuleType


@contextlib.contextmanager
def add_dll_directories_from_env(env_name: str) -> Iterator[None]:
    """Run a block in which the folders of an environment variable would be searched for libraries; here nothing changes."""
    yield


def import_c_library(name: str, package: str | None = None) -> ModuleType:
    """Import a compiled module; a name with a leading dot is one of `package`.

    >>> import_c_library(".cos", "math")
    Traceback (most recent call last):
    ModuleNotFoundError: No module named 'math.cos'; 'math' is not a package
    <BLANKLINE>
    The compiled module '.cos' of 'math' cannot be imported: build its package again, with this Python

    Raises:
        ImportError: if there is no such module, or if it does not fit to this Python.
    """
    try:
        with add_dll_directories_from_env("PATH"):
            return importlib.import_module(name, package)
    except ImportError as error:
        owner = f" of '{package}'" if package else ""
        advice = f"The compiled module '{name}'{owner} cannot be imported: build its package again, with this Python"
        error.msg = f"{error.msg}\n\n{advice}"
        raise
