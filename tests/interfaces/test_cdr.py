"""CDR bytes: as rosbags writes them, and safe to read."""

import random
import struct
import sys
from pathlib import Path

import numpy
import pytest
from hypothesis import given
from hypothesis import strategies as st
from rosbags.typesys import Stores, get_typestore
from std_msgs.msg import String
from test_msgs.message_fixtures import get_test_msg
from test_msgs.msg import BoundedSequences, Empty, MultiNested, Strings, UnboundedSequences, WStrings

from coursekit.interfaces import CdrError, load
from coursekit.interfaces.cdr import deserialize, serialize
from coursekit.interfaces.find import known_interfaces

sys.path.insert(0, str(Path(__file__).parent))
from filling import fill

STORE = get_typestore(Stores.ROS2_HUMBLE)
SHARED = sorted(name for name in known_interfaces() if name in STORE.fielddefs)
ALL = [name for name in known_interfaces() if "/msg/" in name]


def to_rosbags(message):
    """Return rosbags' message with the same values."""
    values = [_to_rosbags(getattr(message, name)) for name in message.get_fields_and_field_types()]
    kind = STORE.types[message._TYPE_NAME]
    return kind(*values) if values else kind()


def _to_rosbags(value):
    if hasattr(value, "SLOT_TYPES"):
        return to_rosbags(value)
    if isinstance(value, bytes):
        return int.from_bytes(value, "little", signed=True)  # rosbags knows an octet as a signed byte
    if isinstance(value, list):
        items = [_to_rosbags(item) for item in value]
        numbers = all(isinstance(item, (bool, int)) for item in items)
        return (
            numpy.array(items, dtype=bool if items and isinstance(items[0], bool) else numpy.int8)
            if numbers
            else items
        )
    return numpy.array(value, dtype=value.typecode) if hasattr(value, "typecode") else value


@pytest.mark.parametrize("name", SHARED)
def test_bytes_are_those_of_rosbags(name):
    generator = random.Random(name)
    for _ in range(4):
        message = fill(load(name)(), generator)
        assert serialize(message) == bytes(STORE.serialize_cdr(to_rosbags(message), name))


@pytest.mark.parametrize("name", ALL)
def test_a_message_comes_back_equal(name):
    generator = random.Random(name)
    for _ in range(3):
        message = fill(load(name)(), generator)
        again = deserialize(serialize(message), type(message))
        assert again == message and serialize(again) == serialize(message)


def test_known_bytes():
    assert serialize(String(data="hi")).hex() == "0001000003000000686900"
    assert serialize(Empty()).hex() == "0001000000"
    assert serialize(WStrings(wstring_value="é"))[:12].hex() == "0001000001000000e9000000"


def test_read_arrays_can_be_written():
    message = deserialize(serialize(MultiNested()), MultiNested)
    message.array_of_arrays[0].int32_values[0] = 5
    assert message.array_of_arrays[0].int32_values[0] == 5


@given(st.binary(max_size=200))
def test_any_bytes_are_a_message_or_a_cdr_error(data):
    for cls in (Strings, UnboundedSequences, BoundedSequences, WStrings, String):
        for start in (b"", b"\0\1\0\0"):
            try:
                assert isinstance(deserialize(start + data, cls), cls)
            except CdrError as error:
                assert str(error)


@given(st.integers(0, 2**16), st.integers(0, 255), st.integers(0, 2**32))
def test_a_changed_byte_never_breaks_out(position, value, seed):
    message = fill(UnboundedSequences(), random.Random(seed))
    data = bytearray(serialize(message))
    data[4 + position % (len(data) - 4)] = value
    try:
        assert isinstance(deserialize(data, UnboundedSequences), UnboundedSequences)
    except CdrError as error:
        assert "test_msgs/msg/UnboundedSequences" in str(error)


def test_a_huge_length_is_refused_before_memory_is_taken():
    data = b"\0\1\0\0" + struct.pack("<I", 0xFFFFFFFF)
    with pytest.raises(CdrError, match="these bytes are no std_msgs/msg/String"):
        deserialize(data, String)


def test_other_encodings_are_named():
    with pytest.raises(CdrError, match="start with 00 00 00 00"):
        deserialize(b"\0\0\0\0\0\0\0\0", String)
    with pytest.raises(CdrError, match="nothing"):
        deserialize(b"", String)


def test_a_list_that_grew_beyond_its_bound_is_not_written():
    message = BoundedSequences()
    message.bool_values.extend([True] * 9)
    with pytest.raises(CdrError, match="'bool_values' has 9 elements; at most 3"):
        serialize(message)


@pytest.mark.parametrize("name", [name for name in ALL if name.startswith("test_msgs/")])
def test_every_test_message_survives(name):
    for message in get_test_msg(name.rpartition("/")[2]):
        assert deserialize(serialize(message), type(message)) == message
