"""Zips that are broken, lie about their size, or hold what is no notebook; by what is wrong with them."""

import io
import os
import struct
import zipfile

from .handed import TOPICS, text, zipped


def zipped_as(kind):
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", kind) as packed:
        packed.writestr(TOPICS, text("q1"))
    return buffer.getvalue()


def corrupt_stream():
    data = bytearray(zipped({TOPICS: text("q1")}))
    data[60:400] = os.urandom(340)
    return bytes(data)


def encrypted():
    data = bytearray(zipped({TOPICS: text("q1")}))
    for mark, at in ((b"PK\3\4", 6), (b"PK\1\2", 8)):
        place = data.index(mark) + at
        data[place] |= 1
    return bytes(data)


def says_small(real=60 << 20):
    """A member that unpacks to more than its header says."""
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w", zipfile.ZIP_DEFLATED) as packed:
        packed.writestr(TOPICS, b" " * real)
    return buffer.getvalue().replace(struct.pack("<I", real), struct.pack("<I", 1000))


def many(count=70_000):
    entry = b"PK\1\2" + b"\0" * 24 + struct.pack("<H", 1) + b"\0" * 16 + b"a"
    return (
        entry * count + b"PK\5\6\0\0\0\0" + struct.pack("<HHIIH", count & 0xFFFF, count & 0xFFFF, len(entry) * count, 0, 0)
    )


def bad_name():
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as packed:
        packed.writestr("ñ02_topics.ipynb", text("q1"))
    return buffer.getvalue().replace("ñ".encode(), b"\xff\xff")


def link():
    buffer = io.BytesIO()
    with zipfile.ZipFile(buffer, "w") as packed:
        info = zipfile.ZipInfo(TOPICS)
        info.external_attr = 0o120777 << 16
        packed.writestr(info, "/etc/passwd")
    return buffer.getvalue()


ZIPS = {
    "a name that is no UTF-8": bad_name,
    "a broken stream": corrupt_stream,
    "encrypted": encrypted,
    "bz2": lambda: zipped_as(zipfile.ZIP_BZIP2),
    "lzma": lambda: zipped_as(zipfile.ZIP_LZMA),
    "nothing": lambda: b"",
    "half": lambda: zipped({TOPICS: text("q1")})[:900],
    "a bomb that says so": lambda: zipped({TOPICS: b" " * (90 << 20)}),
    "a bomb that does not": says_small,
    "more members than may be": many,
    "three deep": lambda: zipped({"a.zip": zipped({"b.zip": zipped({TOPICS: text("q1")})})}),
    "text": lambda: b"<html>Please log in</html>",
    "a link": link,
}
