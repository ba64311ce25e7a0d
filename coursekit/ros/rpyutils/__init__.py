"""Helpers for finding shared libraries on Windows; here they do nothing."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator


@contextlib.contextmanager
def add_dll_directories_from_env(env_name: str) -> Iterator[None]:
    """Run a block in which the folders of an environment variable would be searched for libraries."""
    yield
