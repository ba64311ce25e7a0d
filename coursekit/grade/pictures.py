"""The pictures of evidence that came with a student's work, for their page."""

from __future__ import annotations

import base64
import html
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath

from coursekit.words.gettext import gettext

from .bundle import read_bundle
from .harmless import shown

LARGEST, MOST = 2 << 20, 12
"""Bytes of a picture, and pictures of a person, that are shown."""
_PNG = b"\x89PNG\r\n\x1a\n"


def pictures_in(bundles: Sequence[Path]) -> Iterator[tuple[str, bytes]]:
    """(name, bytes) of the PNG pictures in these files of `hand_in()`; those that are none, or too large, are left out."""
    found = {}
    for file in bundles:
        try:
            _, files = read_bundle(file.read_bytes())
        except (OSError, ValueError):
            continue
        for name, data in files.items():
            if name.startswith("evidence/") and data.startswith(_PNG) and len(data) <= LARGEST:
                found[PurePosixPath(name).name] = data
    yield from sorted(found.items())[:MOST]


def as_html(bundles: Sequence[Path]) -> str:
    """The pictures as part of a page, which needs no other file."""
    shapes = []
    for name, data in pictures_in(bundles):
        source, label = base64.b64encode(data).decode(), html.escape(shown(name, 80), quote=True)
        image = f"<img alt='{label}' src='data:image/png;base64,{source}'>"
        shapes.append(f"<figure>{image}<figcaption>{label}</figcaption></figure>")
    return f"<h2>{gettext('Evidence')}</h2><div class='evidence'>{''.join(shapes)}</div>" if shapes else ""
