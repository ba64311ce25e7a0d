"""zig's C++ library with visible names: only the visibility of global names changes, whatever else the archive holds."""

import struct

import pytest

from coursekit.cpp import standard_library
from coursekit.cpp.standard_library import visible_archive
from tests.needs import posix

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
    before, after = (elf([symbol(*kind) for kind in [*kinds, *others]]) for kinds in (there, wanted))
    assert visible_archive(archive(b"an index", before, b"odd", before)) == archive(b"an index", after, b"odd", after)


@posix("zig's programs load nothing there")
def test_zigs_files_are_found_among_its_words_also_in_a_folder_with_a_space(tmp_path):
    there = tmp_path / "José Luis" / "libc++.a"
    there.parent.mkdir()
    there.write_bytes(archive())
    told = f"ld.lld -o /tmp/a {tmp_path}/none/libc++.a {there} {tmp_path}/libc++abi.a -lc\n"
    assert standard_library._file_in(told, "libc++.a") == there
    with pytest.raises(FileNotFoundError, match=r"names no libc\+\+abi\.a"):
        standard_library._file_in(told, "libc++abi.a")


def test_what_is_no_archive_is_refused():
    with pytest.raises(ValueError, match="no archive"):
        visible_archive(b"\x7fELF")
