"""Images of maps as files: pgm, png, bmp; others are read, too."""

from __future__ import annotations

import errno
import io
import re
import warnings
from pathlib import Path

import cv2
import numpy as np

from coursekit.files import read_bytes, write_whole
from coursekit.nav.map_error import MapError

FORMATS = ("pgm", "png", "bmp")
OTHERS = ("JPEG", "TIFF", "PPM", "GIF", "WEBP")
"""Formats that are read and not written."""
MAX_PIXELS = 8192 * 8192
MAX_BYTES = 512 * 2**20
_PGM = re.compile(rb"(P[25])(?:\s|#[^\n]*\n)+(\d{1,9})(?:\s|#[^\n]*\n)+(\d{1,9})(?:\s|#[^\n]*\n)+(\d{1,5})\s")


def read_picture(path: Path) -> np.ndarray:
    """Return the image, row 0 at the top: gray, or blue, green, red (and alpha), uint8 or uint16; MapError if invalid."""
    data = _bytes(path)
    pgm = _PGM.match(data)
    if pgm:
        return _read_pgm(path, data, pgm)
    if data.startswith(b"\x89PNG\r\n\x1a\n") and len(data) > 24:
        width, height = (int.from_bytes(data[at : at + 4], "big") for at in (16, 20))
    elif data.startswith(b"BM") and len(data) > 26:
        width, height = (abs(int.from_bytes(data[at : at + 4], "little", signed=True)) for at in (18, 22))
    else:
        width, height = _announced(path, data)
    _check_size(path, width, height)
    return _decode(path, data)


def _announced(path: Path, data: bytes) -> tuple[int, int]:
    """Return width and height of an image in another format, such as JPEG, without decoding it."""
    from PIL import Image

    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of huge images, which are refused by their size
        try:
            with Image.open(io.BytesIO(data), formats=OTHERS) as picture:
                return picture.size
        except Exception:  # the readers of five formats raise all kinds of exceptions
            raise _bad(path, "is no picture in a known format", f"use one of: {', '.join(FORMATS)}") from None


def write_picture(path: Path, shades: np.ndarray) -> None:
    """Write an image in the format given by the suffix; OSError if the file cannot be written.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     write_picture(Path(folder, "room.png"), np.array([[0, 205, 254]], np.uint8))
    ...     read_picture(Path(folder, "room.png")).tolist()
    [[0, 205, 254]]
    """
    done, data = cv2.imencode(path.suffix, shades)
    if not done:
        raise OSError(f"{path}: the picture cannot be written as {path.suffix}")
    write_whole(path, data.tobytes())


def _bytes(path: Path) -> bytes:
    try:
        return read_bytes(path, MAX_BYTES)
    except OSError as error:
        if error.errno == errno.EFBIG:
            what = f"the picture is larger than {MAX_BYTES // 2**20} MB"
            raise _bad(path, what, "crop the map or make its cells larger") from None
        reason = getattr(error, "strerror", None) or str(error)
        cure = "put the picture there, or correct 'image:' (a path beside the .yaml)"
        raise _bad(path, f"the picture cannot be read: {reason}", cure) from None


def _decode(path: Path, data: bytes) -> np.ndarray:
    try:
        shades = cv2.imdecode(np.frombuffer(data, dtype=np.uint8), cv2.IMREAD_UNCHANGED)
    except cv2.error:
        shades = None
    if shades is None or shades.dtype not in (np.uint8, np.uint16):
        raise _bad(path, "the picture is damaged", "save the map again")
    return shades


def _read_pgm(path: Path, data: bytes, header: re.Match[bytes]) -> np.ndarray:
    width, height, top = (int(header[group]) for group in (2, 3, 4))
    _check_size(path, width, height)
    if not 0 < top < 65536:
        raise _bad(path, f"its largest shade is {top}", "a pgm's third number is 1 ... 65535, mostly 255")
    if header[1] == b"P5":
        kind = np.dtype(np.uint8 if top < 256 else ">u2")
        body = data[header.end() : header.end() + width * height * kind.itemsize]
        values = np.frombuffer(body, dtype=kind) if len(body) == width * height * kind.itemsize else np.empty(0)
    else:
        values = _text_values(path, data[header.end() :])[: width * height]
    if values.size != width * height:
        raise _bad(path, f"the picture ends before its {width} x {height} pixels do", "save the map again")
    full = 255 if top < 256 else 65535
    shades = np.rint(np.minimum(values, top) * (full / top)) if top != full else values
    return shades.astype(np.uint8 if full == 255 else np.uint16).reshape(height, width)


def _text_values(path: Path, body: bytes) -> np.ndarray:
    try:
        return np.array(re.sub(rb"#[^\n]*", b"", body).split(), dtype=np.uint16)
    except (ValueError, OverflowError):
        raise _bad(path, "holds something that is no shade", "a P2 picture holds whole numbers only") from None


def _check_size(path: Path, width: int, height: int) -> None:
    if not width or not height:
        raise _bad(path, f"is {width} x {height} pixels", "a map has at least one pixel")
    if width * height > MAX_PIXELS:
        what = f"is {width} x {height} pixels, more than {MAX_PIXELS}"
        raise _bad(path, what, "crop the map or make its cells larger")


def _bad(path: Path, what: str, cure: str) -> MapError:
    return MapError(str(path), what, cure, part="picture")
