"""Definitions as OMG IDL."""

from pathlib import Path

import pytest
from rosidl_runtime_py import get_interface_packages, get_interface_path, get_interfaces

from coursekit.interfaces.idl import idl_text
from coursekit.interfaces.parser import parse

TEXT = """
int32 LIMIT=3
string NAME="a \\"b\\""
bool on true
string<=5 word "hi"
int8[2] pair [1, 2]
float64[<=3] few
geometry_msgs/Point[2] ends
geometry_msgs/Point[] path
"""


def test_constants_defaults_bounds_and_arrays_are_written() -> None:
    text = idl_text(parse("p", "msg", "A", TEXT))
    assert text.startswith('#include "geometry_msgs/msg/Point.idl"\n\nmodule p {\n  module msg {\n')
    for line in (
        "typedef int8 int8__2[2];",
        "typedef geometry_msgs::msg::Point geometry_msgs__msg__Point__2[2];",
        "module A_Constants {",
        "const int32 LIMIT = 3;",
        'const string NAME = "a \\"b\\"";',
        "struct A {",
        "@default (value=TRUE)",
        "boolean on;",
        '@default (value="hi")',
        "string<5> word;",
        '@default (value="(1, 2)")',
        "int8__2 pair;",
        "sequence<double, 3> few;",
        "geometry_msgs__msg__Point__2 ends;",
        "sequence<geometry_msgs::msg::Point> path;",
    ):
        assert f"{line}\n" in text
    assert text.count("{") == text.count("}")


@pytest.mark.parametrize(
    ("name", "structures"),
    [
        ("test_msgs/msg/BasicTypes.idl", ["BasicTypes"]),
        ("std_srvs/srv/Empty.idl", ["Empty_Request", "Empty_Response"]),
        ("test_msgs/action/Fibonacci.idl", ["Fibonacci_Goal", "Fibonacci_Result", "Fibonacci_Feedback"]),
    ],
)
def test_the_path_of_an_idl_leads_to_a_file(name: str, structures: list[str]) -> None:
    path = Path(get_interface_path(name))
    assert path.parts[-3:] == tuple(name.split("/"))
    assert [line.split()[1] for line in path.read_text(encoding="utf-8").splitlines() if "struct " in line] == structures
    assert get_interface_path(name) == str(path)


def test_every_interface_that_is_there_has_one() -> None:
    for package, names in get_interfaces(get_interface_packages()).items():
        for name in names:
            assert Path(get_interface_path(f"{package}/{name}.idl")).stat().st_size > 0


def test_an_unknown_one_is_told() -> None:
    with pytest.raises(LookupError, match="Could not find the interface"):
        get_interface_path("test_msgs/msg/Nope.idl")
