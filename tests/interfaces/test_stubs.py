"""Type stubs say what the classes are."""

import pytest

from coursekit.interfaces.find import UNDERLAY
from coursekit.interfaces.parser import parse
from coursekit.interfaces.stubs import stub, underlay_stubs

STUBS = underlay_stubs()


@pytest.mark.parametrize("name", sorted(STUBS))
def test_the_stubs_of_the_underlay_are_those_of_its_definitions(name):
    """When this fails: python -m coursekit.interfaces.stubs"""
    assert (UNDERLAY / "ros" / name).read_text() == STUBS[name]
    compile(STUBS[name], name, "exec")


def test_fields_are_typed_as_they_are_given_and_as_they_are_taken():
    text = stub("p", [parse("p", "msg", "A", "float32[] a\nuint8[3] b\nstd_msgs/Header[] c\nbyte X=1")])
    assert "def a(self) -> array[float]: ..." in text and "a: Collection[float] = ..." in text
    assert "def b(self) -> numpy.typing.NDArray[numpy.uint8]: ..." in text
    assert "def c(self) -> list[std_msgs.msg.Header]: ..." in text and "import std_msgs.msg" in text
    assert "X: ClassVar[bytes]" in text


def test_the_parts_of_a_service_are_types():
    assert "    Request: TypeAlias = Kill_Request" in STUBS["turtlesim/srv/__init__.pyi"]
    assert "    Goal: TypeAlias = RotateAbsolute_Goal" in STUBS["turtlesim/action/__init__.pyi"]
