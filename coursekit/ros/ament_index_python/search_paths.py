"""The search path: the prefixes in AMENT_PREFIX_PATH, which contains coursekit's underlay from the start."""

from __future__ import annotations

import os
from pathlib import Path

from ament_index_python.constants import AMENT_PREFIX_PATH_ENV_VAR
from coursekit.interfaces.find import UNDERLAY, prefixes, with_underlay

with_underlay(os.environ)  # a program that can import this module has, in effect, sourced ROS; a later value wins


def get_search_paths() -> list[str]:
    """Return the existing prefixes, in the order of search.

    Raises:
        OSError: when AMENT_PREFIX_PATH is empty.
    """
    sourced = os.environ.get(AMENT_PREFIX_PATH_ENV_VAR)
    if not sourced:
        raise OSError(f"Environment variable '{AMENT_PREFIX_PATH_ENV_VAR}' is not set or empty: source a workspace first")
    paths = [Path(folder) for folder in sourced.split(os.pathsep) if folder]
    return [str(path) for path in (prefixes() if UNDERLAY in paths else paths) if path.exists()]
