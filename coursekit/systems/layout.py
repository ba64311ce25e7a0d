"""Installation paths of setuptools: scripts and modules are in other places on Windows."""

from __future__ import annotations

import sys
from pathlib import Path

from . import operating_system

_SCRIPT = "-script.py"


def executable_files(folder: Path, name: str) -> list[Path]:
    """Return the possible files of executable `name`, the likeliest first: on Windows also NAME.exe.

    >>> [one.name for one in executable_files(Path("lib/demo"), "talker")]
    ['talker']
    """
    return [folder / name, *([folder / f"{name}.exe"] if operating_system.WINDOWS else [])]


def executable_name(path: Path) -> str:
    """Return the name of an executable: NAME for NAME.exe.

    >>> executable_name(Path("lib/demo/talker.exe")), executable_name(Path("lib/demo/talker"))
    ('talker', 'talker')
    """
    return path.stem if path.suffix == ".exe" else path.name


def is_executables_part(path: Path) -> bool:
    """Whether a file is only part of an executable: NAME-script.py is started by NAME.exe."""
    return path.name.endswith(_SCRIPT) and path.with_name(path.name.removesuffix(_SCRIPT) + ".exe").is_file()


def python_script(path: Path) -> Path:
    """Return the file that Python runs for an executable: NAME-script.py for setuptools' NAME.exe, else the file itself."""
    script = path.with_name(path.stem + _SCRIPT)
    return script if path.suffix == ".exe" and script.is_file() else path


def site_packages(prefix: Path) -> Path:
    """Return the folder of Python modules below a prefix.

    >>> import sysconfig
    >>> site_packages(Path("install/demo")) == Path(sysconfig.get_path("purelib", "posix_prefix", {"base": "install/demo"}))
    True
    """
    version = f"python{sys.version_info.major}.{sys.version_info.minor}"
    return prefix / "Lib" / "site-packages" if operating_system.WINDOWS else prefix / "lib" / version / "site-packages"
