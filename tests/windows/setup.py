"""Makes all that is needed once: Wine's prefix, Windows' Python, the course as the README installs it, what Wine lacks."""

from __future__ import annotations

import hashlib
import shutil
import sys
from typing import Any

from . import lacking, windows_python, wine

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

ONLY_OUTSIDE = ("playwright", "nbgrader", "robot-properties", "pin>", "ruff", "mypy", "types-", "check-jsonschema")
"""Of the test's packages, those that are of no use in Wine: browsers, lint, types, what has no wheel for Windows."""
_stamp = wine.HOME / "stamp"


def set_up(version: str = "3.11") -> None:
    """Set up what is not there yet; again when the course's dependencies or this script have changed."""
    wine.HOME.mkdir(parents=True, exist_ok=True)
    if _stamp.is_file() and _stamp.read_text(encoding="utf-8") == _state(version):
        wine.must_run(wine.PYTHON, "-m", "coursekit.building.underlay")  # an update may have brought new messages
        return
    _stamp.unlink(missing_ok=True)  # an interrupted set-up must not pass for the one before it
    python = windows_python.unpack(version, wine.HOME)
    wine.must_run("cmd", "/c", "ver")
    lacking.get_tools()
    lacking.add_random_bytes()
    lacking.add_commands()
    wine.must_run(python, "-m", "venv", "--clear", "--without-pip", wine.VENV)
    windows_python.add_pip(python, wine.VENV)
    shutil.copy(wine.PYTHON, wine.PYTHON.with_name("python3.exe"))  # as launch files call it
    _install("-c", "requirements.lock", "-e", ".", *_test_packages())
    lacking.add_complex_functions()
    lacking.one_thread_for_opencv()
    wine.must_run(wine.PYTHON, "-c", "import numpy, scipy.linalg, cv2, numba, zmq, rpds, coursekit.lab")
    _stamp.write_text(_state(version), encoding="utf-8")


def _install(*words: str) -> None:
    """With nothing compiled: in Wine that takes minutes, for modules that nobody may need."""
    wine.must_run(wine.PYTHON, "-m", "pip", "install", "-q", "--no-compile", *words)


def _test_packages() -> list[str]:
    wanted = _project()["optional-dependencies"]["test"]
    return [requirement for requirement in wanted if not requirement.startswith(ONLY_OUTSIDE)]


def _project() -> dict[str, Any]:
    """What is installed, and which commands it has; lint and the like, which stand in the same file, change nothing."""
    with open(wine.ROOT / "pyproject.toml", "rb") as file:
        return dict(tomllib.load(file)["project"])


def _state(version: str) -> str:
    here = wine.ROOT / "tests" / "windows"
    makers = [*here.glob("*.c"), here / "lacking.py", here / "setup.py", here / "windows_python.py"]
    files = [wine.ROOT / "requirements.lock", *sorted(makers)]
    said = [version.encode(), str(wine.ROOT).encode(), repr(_project()).encode(), *(file.read_bytes() for file in files)]
    return hashlib.sha256(b"".join(said)).hexdigest()
