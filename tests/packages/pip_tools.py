"""An environment whose compiler, CMake and ninja are those of `coursekit[cpp]` alone: the system's are hidden."""

import importlib.util
import os
import shutil
import sys

import pytest

from tests.compiler_cache import LAUNCHERS
from tests.needs import ON_WINDOWS, compiler_or_skip
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


def loading_tools_or_skip(whose, folder):
    """The environment of "pip's tools" or of this computer's own, where programs load libraries: zig's do on Linux alone."""
    is_zig = whose == "pip's tools" or "ziglang" in str(compiler_or_skip().cxx)
    if is_zig and sys.platform != "linux":
        pytest.skip("needs a system's compiler: zig's libraries have a C++ library of their own each")
    return pip_tools_or_skip(folder) if whose == "pip's tools" else ENV
