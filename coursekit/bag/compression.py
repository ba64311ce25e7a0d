"""zstd, for single messages or whole files. The output size is limited: a few bytes can expand to gigabytes."""

from __future__ import annotations

import shutil
from pathlib import Path

from coursekit.bag.errors import BagError

FORMAT = "zstd"
SUFFIX = ".zstd"
MODES = ("", "FILE", "MESSAGE")
LARGEST_MESSAGE = 1_000_000_000
"""Maximum size of a message in bytes: sqlite3's limit."""
LARGEST_FILE = 64 * 2**30
"""Maximum size of a bag file in bytes."""
_PIECE = 1 << 20
_KEPT_FREE = 100 * 2**20


def check(mode: str, kind: str) -> None:
    """Raise BagError for an unknown mode or format.

    >>> check("file", "lz4")
    Traceback (most recent call last):
    coursekit.bag.errors.BagError: there is no compression format 'lz4'; there is zstd
    """
    if mode.upper() not in (*MODES, "NONE"):
        raise BagError(f"there is no compression mode '{mode.lower()}'; there are none, file and message")
    if mode.upper() in MODES[1:] and kind != FORMAT:
        raise BagError(f"there is no compression format '{kind}'; there is {FORMAT}")


def compress(data: bytes) -> bytes:
    """Return a message's bytes, compressed.

    >>> scan = bytes(1000)
    >>> len(compress(scan)) < 50, decompress(compress(scan)) == scan
    (True, True)
    """
    import zstandard

    return zstandard.ZstdCompressor().compress(data)


def decompress(data: bytes, limit: int = LARGEST_MESSAGE) -> bytes:
    """Return a message's bytes, decompressed; BagError when they are invalid or more than `limit`.

    >>> decompress(compress(b"scan" * 1000), limit=100)
    Traceback (most recent call last):
    coursekit.bag.errors.BagError: a compressed message has more than 100 bytes: it is not unpacked
    """
    import zstandard

    out = bytearray()
    try:
        with zstandard.ZstdDecompressor().stream_reader(data) as stream:
            while piece := stream.read(_PIECE):
                out += piece
                if len(out) > limit:
                    raise BagError(f"a compressed message has more than {limit} bytes: it is not unpacked")
    except (zstandard.ZstdError, MemoryError) as error:
        raise BagError(f"a message cannot be unpacked with zstd: {error}") from None
    return bytes(out)


def compress_file(path: Path) -> Path:
    """Replace a file by its compressed form, NAME.zstd, and return the new path."""
    import zstandard

    packed = path.with_name(path.name + SUFFIX)
    with path.open("rb") as source, packed.open("wb") as target:
        zstandard.ZstdCompressor().copy_stream(source, target, size=path.stat().st_size)
    path.unlink()
    return packed


def decompress_file(path: Path, folder: Path) -> Path:
    """Decompress NAME.zstd into a folder and return the file; BagError when it is broken or does not fit on the disk."""
    import zstandard

    target = folder / path.name.removesuffix(SUFFIX)
    limit = min(LARGEST_FILE, max(0, shutil.disk_usage(folder).free - _KEPT_FREE))
    written = 0
    try:
        with path.open("rb") as source, target.open("wb") as out:
            for piece in zstandard.ZstdDecompressor().read_to_iter(source):
                written += len(piece)
                if written > limit:
                    raise BagError(f"'{path}' has more than {limit} bytes when unpacked: there is no room for it")
                out.write(piece)
    except (zstandard.ZstdError, OSError) as error:
        raise BagError(f"'{path}' cannot be unpacked with zstd: {error}") from None
    return target
