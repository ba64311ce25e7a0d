"""The wheel alone is the whole course: nothing of the checkout is read, nothing is left out."""

import os
import subprocess
import sys
import sysconfig
from pathlib import Path

import pytest

from coursekit.building.underlay import files

ROOT = Path(__file__).parents[2]
WHERE = "import coursekit, rclpy; print(coursekit.__file__); print(rclpy.__file__)"
pytestmark = [pytest.mark.slow, pytest.mark.timeout(600)]


def _said(*words, folder):
    env = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "AMENT_PREFIX_PATH")}
    done = subprocess.run([*map(str, words)], cwd=folder, env=env, capture_output=True, encoding="utf-8", check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Empty but for an environment that has the wheel; other packages are found where this Python has them."""
    folder = tmp_path_factory.mktemp("elsewhere")
    offline = ("-q", "--disable-pip-version-check", "--no-deps", "--no-index")
    _said(sys.executable, "-m", "pip", "wheel", *offline, "--no-build-isolation", "-w", folder / "dist", ROOT, folder=folder)
    [wheel] = (folder / "dist").iterdir()
    _said(sys.executable, "-m", "venv", "--without-pip", folder / "env", folder=folder)
    _said(sys.executable, "-m", "pip", "--python", _python(folder), "install", *offline, wheel, folder=folder)
    # The .pth files of a folder that a .pth file names are not read: the checkout is not found by its own.
    (_packages(folder) / "others.pth").write_text(sysconfig.get_path("purelib"), encoding="utf-8")
    return folder


def _python(folder):
    return folder / "env" / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")


def _packages(folder):
    code = "import sysconfig; print(sysconfig.get_path('purelib'))"
    return Path(_said(_python(folder), "-c", code, folder=folder).strip())


def test_coursekit_and_ros_come_from_the_wheel(folder):
    places = _said(_python(folder), "-c", WHERE, folder=folder).splitlines()
    assert [Path(place).is_relative_to(_packages(folder)) for place in places] == [True, True]


def test_an_empty_folder_becomes_the_whole_course(folder):
    name = "coursekit.exe" if sys.platform == "win32" else "coursekit"
    _said(_python(folder).parent / name, "course", folder=folder)
    chapters = {path.name for path in (ROOT / "notebooks").glob("*.ipynb")}
    assert {path.name for path in (folder / "course").glob("*.ipynb")} == chapters
    pictures = {path.name for path in (ROOT / "notebooks" / "images").iterdir()}
    assert {path.name for path in (folder / "course" / "images").iterdir()} == pictures


def test_it_has_every_file_of_the_underlay(folder):
    there = _packages(folder) / "coursekit"
    assert [name for name in files() if not (there / name).is_file()] == []
