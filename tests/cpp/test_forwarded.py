"""Headers that only include another one: what they include is there, and nothing stands under a name twice."""

from coursekit.cpp.forwarded import FORWARDED, write_forwarded
from coursekit.cpp.runtime import ROOM


def headers_of(folder):
    return {path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file()}


def test_each_includes_a_header_that_is_there_under_another_name(tmp_path):
    write_forwarded(tmp_path)
    written, own = headers_of(tmp_path), headers_of(ROOM / "include")
    assert written.isdisjoint(own)
    assert own.issuperset(FORWARDED)
