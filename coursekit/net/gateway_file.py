"""Writes the gateway and the wire format that it shares with notebooks to one file that Python can run."""

from __future__ import annotations

import zipfile
from importlib import resources
from pathlib import Path

NAME = "coursekit_gateway"
FOLDERS = ("wire", "gateway")
START = f"from {NAME}.gateway.program import main\n\nraise SystemExit(main())\n"


def write(path: Path) -> None:
    """Write the file, with identical bytes every time. Raises OSError when it cannot be written."""
    files = {"__main__.py": START, f"{NAME}/__init__.py": '"""What `coursekit gateway --write` wrote."""\n'}
    for folder in FOLDERS:
        for file in sorted(resources.files("coursekit.net").joinpath(folder).iterdir(), key=lambda file: file.name):
            if file.name.endswith(".py"):
                files[f"{NAME}/{folder}/{file.name}"] = file.read_text(encoding="utf-8")
    with open(path, "wb") as out:
        out.write(b"#!/usr/bin/env python3\n")
        with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
            for name, text in files.items():
                entry = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
                entry.compress_type = zipfile.ZIP_DEFLATED
                archive.writestr(entry, text)
    path.chmod(0o755)
