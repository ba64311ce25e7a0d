"""The scripts `local_setup.*` of a package: they set up that package alone, as ament's do."""

from __future__ import annotations

import shlex
from pathlib import Path

_BY_PLACE = {
    "bash": '. "$(builtin cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/package.bash"\n',
    "zsh": '. "${0:A:h}/package.zsh"\n',
    "ps1": '. "$PSScriptRoot/package.ps1"\n',
    "bat": '@call "%~dp0package.bat"\n',
    "dsv": "source;share/{package}/package.dsv\n",
}
"""The content of each script: a shell that knows its script's path finds the other one relative to it."""


def local_setup_files(prefix: Path, package: str) -> dict[str, str]:
    """Return the scripts with their text, by path below the prefix, for the shells for which colcon created one.

    >>> local_setup_files(Path("nowhere"), "k_map")
    {}
    """
    folder = Path("share", package)
    kinds = [path.suffix[1:] for path in sorted((prefix / folder).glob("package.*"))]
    return {(folder / f"local_setup.{kind}").as_posix(): text for kind in kinds if (text := _text(kind, prefix, package))}


def _text(kind: str, prefix: Path, package: str) -> str:
    if kind == "sh":  # it cannot find its own path
        path = prefix / "share" / package / "package.sh"
        return f". {shlex.quote(str(path))}\n"  # noqa: TID251 - a POSIX shell reads it
    return _BY_PLACE.get(kind, "").replace("{package}", package)
