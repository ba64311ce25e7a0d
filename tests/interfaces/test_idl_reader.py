"""Interfaces that are written in IDL."""

from __future__ import annotations

import pytest

from coursekit.interfaces.errors import InterfaceError
from coursekit.interfaces.find import known_interfaces
from coursekit.interfaces.idl import definition_file, idl_text, is_translated
from coursekit.interfaces.idl_reader import definition_of_idl
from coursekit.interfaces.parser import parse, parse_file
from coursekit.interfaces.registry import interface_of

POINT = """// as other tools write it
#include "k_idl/msg/Plain.idl"
module k_idl {
  module msg {
    typedef double double__36[36];
    /* constants
       come first */
    module Point_Constants {
      const unsigned long long MOST = 10;
      @verbatim (language="comment", text="a" "b")
      const string UNIT = "m";
    };
    @verbatim (language="comment", text=
      "A point; {it} has @notes.")
    struct Point {
      @unit (value="m") double x, y;
      @default (value=TRUE)
      boolean ok;
      @default (value="(1, 2)")
      sequence<long, 3> some;
      sequence<string<10>> names;
      float cov[9];
      double__36 more;
      octet o;
      k_idl::msg::Plain plain;
      std_msgs::msg::Header header;
    };
  };
};
"""


@pytest.fixture
def written(tmp_path):
    def write(text, name="Point"):
        path = tmp_path / f"{name}.idl"
        path.write_text(text, encoding="utf-8")
        return path

    return write


def test_a_structure_is_a_message(written):
    kind, text = definition_of_idl(written(POINT))
    assert kind == "msg"
    assert text.splitlines() == [
        "uint64 MOST=10",
        'string UNIT="m"',
        "float64 x",
        "float64 y",
        "bool ok true",
        "int32[<=3] some [1, 2]",
        "string<=10[] names",
        "float32[9] cov",
        "float64[36] more",
        "byte o",
        "k_idl/Plain plain",
        "std_msgs/Header header",
    ]


FROM = ("test_msgs/", "example_interfaces/", "geometry_msgs/")
SOME = [name for name in known_interfaces() if name.startswith(FROM) and not name.endswith("/Arrays")]
"""Without Arrays: IDL does not tell its char from uint8."""


@pytest.mark.parametrize("name", SOME)
def test_what_is_written_as_idl_is_read_as_it_was(written, name):
    package, kind, short = name.split("/")
    text = idl_text(interface_of(name))
    assert definition_of_idl(path := written(text, short))[0] == kind
    assert idl_text(parse(package, kind, short, definition_of_idl(path)[1])) == text


@pytest.mark.parametrize(
    ("text", "line", "why"),
    [
        ("module a {\n  module msg {\n    struct Point {\n      map<long> x;", 4, "is not IDL"),
        ("module a { struct Point { long x; }; };", 0, "module msg, srv or action"),
        ("module a { module msg { struct Other { long x; }; }; };", 0, "no struct Point"),
        ("module a { module msg { typedef long b[2]; struct Point { sequence<b> x; }; }; };", 0, "arrays of arrays"),
        ("", 1, "is not IDL"),
    ],
)
def test_what_ros_does_not_understand_is_told(written, text, line, why):
    with pytest.raises(InterfaceError, match=why) as caught:
        definition_of_idl(written(text))
    assert caught.value.line == line


def test_a_file_in_idl_stands_for_one_of_ros(written):
    definition = definition_file(path := written("module a { module msg { struct Point { long x; }; }; };"))
    assert is_translated(definition) and not is_translated(path)
    assert [field.name for field in parse_file("a", definition).fields] == ["x"]
    assert definition_file(definition) == definition
