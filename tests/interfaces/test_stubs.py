"""Type stubs say what the classes are."""

from coursekit.interfaces.parser import parse
from coursekit.interfaces.stubs import stub


def test_fields_are_typed_as_they_are_given_and_as_they_are_taken():
    text = stub([parse("p", "msg", "A", "float32[] a\nuint8[3] b\nstd_msgs/Header[] c\nbyte X=1")])
    assert "def a(self) -> array[float]: ..." in text and "a: Collection[float] = ..." in text
    assert "def b(self) -> numpy.typing.NDArray[numpy.uint8]: ..." in text
    assert "def c(self) -> list[std_msgs.msg.Header]: ..." in text and "import std_msgs.msg" in text
    assert "X: ClassVar[bytes]" in text


def test_the_parts_of_a_service_are_types():
    assert "    Request: TypeAlias = Kill_Request" in stub([parse("p", "srv", "Kill", "string name\n---")])
    assert "    Goal: TypeAlias = Turn_Goal" in stub([parse("p", "action", "Turn", "float32 by\n---\n---")])
