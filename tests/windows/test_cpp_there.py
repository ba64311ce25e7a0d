"""C++ on Windows itself: `coursekit cpp`, and a package that is created, built and run there; `make windows`.

Compiled by zig of Windows in Wine 10 or newer, which takes minutes; Debian 12's Wine 8 cannot run it.
"""

from __future__ import annotations

import io
from pathlib import Path

import pytest

from tests.windows import cpp_course, lacking, wine
from tests.windows.test_cpp import LISTENER, TALKER, story

pytestmark = [pytest.mark.slow, pytest.mark.timeout(3600)]
SCRIPTS = wine.VENV / "Scripts"
NEEDED = 10


@pytest.fixture(scope="module")
def cpp() -> str:
    """What `coursekit cpp` said when it had got its tools and made the runtime."""
    if why := cpp_course.why_no_wine():
        pytest.skip(why)
    if wine.version() < NEEDED:
        pytest.skip(f"zig needs Wine {NEEDED}, and this is {wine.version()}")
    from coursekit.cli.cpp import wheels

    wine.must_run(wine.PYTHON, "-m", "pip", "install", "-q", *wheels())
    lacking.add_system_calls()
    return said_by(SCRIPTS / "coursekit.exe", "cpp", folder=wine.ROOT)


def said_by(program: str | Path, *words: str, folder: Path) -> str:
    """What a command says, which has to succeed."""
    said = io.BytesIO()
    code = wine.run(program, *words, folder=folder, seconds=1800, to=said, extra={"PYTHONUTF8": "1"})
    text = said.getvalue().decode(errors="replace").replace("\r\n", "\n")
    assert code == 0, text
    return text


def test_the_tools_are_got_and_the_runtime_is_made(cpp: str) -> None:
    assert "C++ is ready" in cpp and "zig.exe" in cpp


@pytest.fixture
def src(cpp: str, tmp_path: Path) -> Path:
    """Where the packages of a new workspace are written."""
    folder = tmp_path / "ros2_ws" / "src"
    folder.mkdir(parents=True)
    return folder


def test_a_package_is_created_built_and_run(src: Path) -> None:
    words = ("pkg", "create", "--build-type", "ament_cmake", "--node-name", "hello", "words")
    said_by(SCRIPTS / "ros2.exe", *words, folder=src)
    assert "Finished <<< words" in said_by(SCRIPTS / "colcon.exe", "build", folder=src.parent)
    said = said_by("cmd", "/c", "call install\\setup.bat && ros2 run words hello", folder=src.parent)
    assert said.splitlines()[-1] == "hello world words package"  # Wine's cmd also shows a comment of the script


def test_nodes_that_were_built_there_talk(src: Path) -> None:
    cpp_course.write(src / "far", {"talker": TALKER, "listener": LISTENER})
    said_by(SCRIPTS / "colcon.exe", "build", folder=src.parent)
    (_, said), (_, heard) = story(src.parent / "install" / "far", "virtual", "pair")
    assert said.endswith("said 3\n") and "[1700000001.500000000] [listener]: heard ¡hola 3!" in heard
