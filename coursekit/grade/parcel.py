"""The one file that a student hands in: the notebook, pictures, what happened, and a manifest with the mark of a clean run.

It shows changes, it does not prevent them: the mark that counts comes from running the notebook again.
"""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Mapping
from typing import Any

from . import events

MANIFEST, EVENTS = "manifest.json", "events.jsonl"
LARGEST = 100 << 20
"""Bytes of a parcel."""
_DATE = (1980, 1, 1, 0, 0, 0)


def pack_parcel(files: Mapping[str, bytes], facts: Mapping[str, Any]) -> bytes:
    """A parcel with these files; the same contents give the same bytes."""
    listed = {name: hashlib.sha256(data).hexdigest() for name, data in sorted(files.items())}
    manifest: dict[str, Any] = {**facts, "files": listed}
    manifest["seal"] = events.digest(manifest)
    return _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in listed}})


def cell_digests(notebook: Mapping[str, Any]) -> list[str]:
    """A digest of the text of each cell."""
    return [hashlib.sha256("".join(cell.get("source", "")).encode()).hexdigest() for cell in notebook.get("cells", [])]


def read_parcel(data: bytes) -> tuple[dict[str, Any], dict[str, bytes]]:
    """The manifest and the files; ValueError when it is no parcel."""
    if len(data) > LARGEST:
        raise ValueError(f"it is larger than {LARGEST >> 20} MB")
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as opened:
            if sum(one.file_size for one in opened.infolist()) > LARGEST:
                raise ValueError(f"it unpacks to more than {LARGEST >> 20} MB")
            files = {one.filename: opened.read(one) for one in opened.infolist()}
        manifest = json.loads(files.pop(MANIFEST))
    except (zipfile.BadZipFile, KeyError, NotImplementedError, RuntimeError, OSError, EOFError) as error:
        raise ValueError(f"it is no parcel made by hand_in(): {error}") from None
    if not isinstance(manifest, dict) or not isinstance(manifest.get("files"), dict):
        raise ValueError("its manifest is none")
    return manifest, files


def parcel_faults(data: bytes) -> list[str]:
    """Every sign that it was changed after it was made."""
    try:
        manifest, files = read_parcel(data)
    except ValueError as error:
        return [str(error)]
    found = [f"{name}: is missing" for name in manifest["files"] if name not in files]
    for name, content in files.items():
        if name not in manifest["files"]:
            found.append(f"{name}: was put in afterwards")
        elif hashlib.sha256(content).hexdigest() != manifest["files"][name]:
            found.append(f"{name}: was changed")
    if events.digest({key: value for key, value in manifest.items() if key != "seal"}) != manifest.get("seal"):
        found.append(f"{MANIFEST}: was changed")
    found += events.faults(files.get(EVENTS, b"").decode(errors="replace").splitlines())
    if not found and _zipped({MANIFEST: _text(manifest), **{name: files[name] for name in manifest["files"]}}) != data:
        found.append("the zip was packed anew")
    return found


def _text(manifest: Mapping[str, Any]) -> bytes:
    return json.dumps(manifest, indent=1, sort_keys=True).encode()


def _zipped(files: Mapping[str, bytes]) -> bytes:
    """Stored, in this order, without dates: nothing in it depends on the machine."""
    made = io.BytesIO()
    with zipfile.ZipFile(made, "w", zipfile.ZIP_STORED) as packed:
        for name, data in files.items():
            packed.writestr(zipfile.ZipInfo(name, _DATE), data)
    return made.getvalue()
