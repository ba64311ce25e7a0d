"""zig's C++ library with visible names: only the visibility of global names changes, whatever else the archive holds."""

import struct

import pytest

from coursekit.cpp.standard_library import visible_archive

LOCAL, GLOBAL, WEAK = 0, 1, 2
DEFAULT, INTERNAL, HIDDEN, PROTECTED = 0, 1, 2, 3


def symbol(binding, visibility):
    return struct.pack("<IBBHQQ", 0, binding << 4 | 1, visibility, 1, 0, 0)


def elf(symbols):
    """A 64-bit object file of a header, one table of symbols and one header of a section."""
    table = b"".join(symbols)
    header = b"\x7fELF" + bytes(36) + struct.pack("<Q", 64 + len(table)) + bytes(10) + struct.pack("<HHH", 64, 1, 0)
    section = struct.pack("<IIQQQQIIQQ", 0, 2, 0, 0, 64, len(table), 0, 0, 0, 24)
    return header + table + section


def archive(*members):
    written = b"!<arch>\n"
    for data in members:
        written += b"%-48s%-10d`\n" % (b"name/", len(data)) + data + b"\n" * (len(data) % 2)
    return written


def test_hidden_global_names_are_seen_and_nothing_else_changes():
    others = [(LOCAL, HIDDEN), (GLOBAL, PROTECTED), (WEAK, INTERNAL)]
    there, wanted = [(GLOBAL, HIDDEN), (WEAK, HIDDEN)], [(GLOBAL, DEFAULT), (WEAK, DEFAULT)]
    before, after = (elf([symbol(*one) for one in [*kinds, *others]]) for kinds in (there, wanted))
    assert visible_archive(archive(b"an index", before, b"odd", before)) == archive(b"an index", after, b"odd", after)


def test_what_is_no_archive_is_refused():
    with pytest.raises(ValueError, match="no archive"):
        visible_archive(b"\x7fELF")
