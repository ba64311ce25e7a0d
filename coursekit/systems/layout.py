"""Where setuptools puts what it installs: scripts and modules lie elsewhere on Windows."""

from __future__ import annotations

import sys
from pathlib import Path

from . import which

_SCRIPT = "-script.py"


def executable_files(folder: Path, name: str) -> list[Path]:
    """The files that `name` may stand for, the likeliest first: NAME.exe counts on Windows.

    >>> [one.name for one in executable_files(Path("lib/demo"), "talker")]
    ['talker']
    """
    return [folder / name, *([folder / f"{name}.exe"] if which.WINDOWS else [])]


def executable_name(path: Path) -> str:
    """By what name an executable is called: NAME of NAME.exe.

    >>> executable_name(Path("lib/demo/talker.exe")), executable_name(Path("lib/demo/talker"))
    ('talker', 'talker')
    """
    return path.stem if path.suffix == ".exe" else path.name


def is_executables_part(path: Path) -> bool:
    """Whether a file is no program by itself but belongs to one: NAME-script.py is what NAME.exe starts."""
    return path.name.endswith(_SCRIPT) and path.with_name(path.name.removesuffix(_SCRIPT) + ".exe").is_file()


def python_script(path: Path) -> Path:
    """The file that Python runs for an executable: NAME-script.py for setuptools' NAME.exe, else the file itself."""
    script = path.with_name(path.stem + _SCRIPT)
    return script if path.suffix == ".exe" and script.is_file() else path


def site_packages(prefix: Path) -> Path:
    """The folder of Python modules that are installed under a prefix.

    >>> import sysconfig
    >>> site_packages(Path("install/demo")) == Path(sysconfig.get_path("purelib", "posix_prefix", {"base": "install/demo"}))
    True
    """
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    return prefix / "Lib" / "site-packages" if which.WINDOWS else prefix / "lib" / version / "site-packages"
