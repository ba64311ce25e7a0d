"""An environment whose compiler, CMake and ninja are those of `coursekit[cpp]` alone: the system's are hidden."""

import importlib.util
import os
import shutil

import pytest

from tests.compiler_cache import LAUNCHERS
from tests.needs import ON_WINDOWS
from tests.packages.test_cpp_workspace import BIN, ENV

MISSING = [name for name in ("ziglang", "cmake", "ninja") if importlib.util.find_spec(name) is None]


def pip_tools_or_skip(folder):
    """The environment; its programs are this Python's, and links in the folder to the few that colcon's own scripts need."""
    if ON_WINDOWS or MISSING:
        pytest.skip(f"needs pip install 'coursekit[cpp]': there is no {', '.join(MISSING)}")
    for name in ("env", "sh", "bash"):
        (folder / name).symlink_to(shutil.which(name))
    own = {name: value for name, value in ENV.items() if name not in LAUNCHERS}
    return own | {"PATH": f"{BIN}{os.pathsep}{folder}"}
