"""The pictures of evidence in a student's work, for the student's page."""

from __future__ import annotations

import base64
import html
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePosixPath

from coursekit.words.gettext import gettext

from .bundle import read_bundle
from .sanitizing import shown

LARGEST, MOST = 2 << 20, 12
"""The maximum size of a picture [bytes], and the maximum number of pictures of a person."""
_PNG = b"\x89PNG\r\n\x1a\n"


def pictures_in(bundles: Sequence[Path]) -> Iterator[tuple[str, bytes]]:
    """Yield (name, bytes) of the PNG pictures in these files of `hand_in()`, without invalid or too large ones."""
    data_by_name = {}
    for file in bundles:
        try:
            _, files = read_bundle(file.read_bytes())
        except (OSError, ValueError):
            continue
        for name, data in files.items():
            if name.startswith("evidence/") and data.startswith(_PNG) and len(data) <= LARGEST:
                data_by_name[PurePosixPath(name).name] = data
    yield from sorted(data_by_name.items())[:MOST]


def as_html(bundles: Sequence[Path]) -> str:
    """Return the pictures as a self-contained part of a page."""
    shapes = []
    for name, data in pictures_in(bundles):
        source, label = base64.b64encode(data).decode(), html.escape(shown(name, 80), quote=True)
        image = f"<img alt='{label}' src='data:image/png;base64,{source}'>"
        shapes.append(f"<figure>{image}<figcaption>{label}</figcaption></figure>")
    return f"<h2>{gettext('Evidence')}</h2><div class='evidence'>{''.join(shapes)}</div>" if shapes else ""
