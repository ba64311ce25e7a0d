"""Lines of text files, plain or compressed, from untrusted sources."""

from __future__ import annotations

import bz2
import gzip
import lzma
from collections.abc import Iterator
from pathlib import Path
from typing import IO

LONGEST = 1 << 20
"""Longer lines are split: no scan needs them, and a file without line ends must not fill the memory."""


def read_lines(path: str | Path) -> Iterator[str]:
    r"""Yield the lines of a text file, decompressing `.gz`, `.bz2` and `.xz`; invalid bytes become a replacement character.

    Raises FileNotFoundError, IsADirectoryError, or ValueError when the compressed data are damaged.

    >>> import tempfile
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = Path(folder, "log.gz")
    ...     _ = file.write_bytes(gzip.compress(b"PARAM a 1\nPARAM b 2\n"))
    ...     [line.strip() for line in read_lines(file)]
    ['PARAM a 1', 'PARAM b 2']
    """
    file = Path(path)
    if not file.exists():
        raise FileNotFoundError(f"no file {file}: check the name, the present folder is {Path.cwd()}")
    if file.is_dir():
        raise IsADirectoryError(f"{file} is a folder: name a file in it")
    with _open(file) as stream:
        try:
            yield from _lines(stream)
        except (OSError, EOFError, lzma.LZMAError) as fault:
            raise ValueError(f"{file} is damaged or not what its name suggests: {fault}") from fault


def _open(file: Path) -> IO[bytes]:
    """Open the file, decompressing it according to its magic number."""
    with file.open("rb") as stream:
        magic = stream.read(6)
    if magic[:2] == b"\x1f\x8b":
        return gzip.open(file, "rb")  # type: ignore[return-value]
    if magic == b"\xfd7zXZ\x00":
        return lzma.open(file, "rb")  # type: ignore[return-value]
    if magic[:3] == b"BZh":
        return bz2.open(file, "rb")  # type: ignore[return-value]
    return file.open("rb")


def _lines(stream: IO[bytes]) -> Iterator[str]:
    """Yield lines of at most LONGEST bytes; longer ones come in pieces."""
    while line := stream.readline(LONGEST):
        yield line.decode("utf-8", "replace")
