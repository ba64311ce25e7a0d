"""The compiler, CMake and ninja of `coursekit[cpp]` alone build a workspace that runs; skipped where they are missing."""

from __future__ import annotations

import importlib.util
import os
import shutil
import subprocess
import sys

import pytest

from tests.needs import ON_WINDOWS
from tests.packages.test_cpp_workspace import BIN, ENV, SOURCES, alone

pytestmark = [pytest.mark.slow, pytest.mark.timeout(900)]
MISSING = [name for name in ("ziglang", "cmake", "ninja") if importlib.util.find_spec(name) is None]


@pytest.fixture(scope="module")
def workspace(tmp_path_factory):
    if ON_WINDOWS or MISSING:
        pytest.skip(f"needs pip install 'coursekit[cpp]': there is no {', '.join(MISSING)}")
    folder = tmp_path_factory.mktemp("pip_tools")
    shutil.copytree(SOURCES, folder / "src")
    (folder / "bin").mkdir()
    for name in ("env", "sh", "bash"):  # what colcon's own scripts need
        (folder / "bin" / name).symlink_to(shutil.which(name))
    env = ENV | {"PATH": f"{BIN}{os.pathsep}{folder / 'bin'}"}
    built = subprocess.run([str(BIN / "colcon"), "build"], cwd=folder, env=env, capture_output=True, encoding="utf-8")
    assert built.returncode == 0 and "5 packages finished" in built.stdout, built.stdout + built.stderr
    assert "Skipped C++" not in built.stdout
    return folder


@pytest.mark.parametrize("virtual", [True, False])
def test_actions_components_and_transforms_run(workspace, virtual):
    what = "mast = start('mast')\nprint(mast.wait(10.0), mast.output)\nwinch, winder = start('winch_node'), start('winder')"
    said = alone(workspace, f"{what}\nprint(winder.wait(20.0), winder.output)\nwinch.interrupt()\nwinch.wait(5.0)", virtual)
    assert "(0.00, 3.00, 1.00) in world, yaw 1.5708" in said and "succeeded after 3" in said


def test_nothing_of_the_system_was_used(workspace):
    cache = (workspace / "build" / "k_parts" / "CMakeCache.txt").read_text(encoding="utf-8")
    assert os.path.join("zig", "c++") in cache and os.path.dirname(sys.executable) in cache
