import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import PoseStamped
from nav_msgs.msg import OccupancyGrid
from rclpy.serialization import deserialize_message, serialize_message
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Bool, Float64, Header, Int8, String
from std_srvs.srv import SetBool
from test_msgs.msg import Arrays, BasicTypes, BoundedSequences, Nested, Strings, UnboundedSequences

MESSAGES = [
    String(data="hello"),
    String(data="grüße ☃"),
    Bool(data=True),
    Int8(data=-5),
    Float64(data=1.25),
    Time(sec=-1, nanosec=5),
    Header(stamp=Time(sec=3), frame_id="map"),
    PoseStamped(header=Header(frame_id="odom")),
    LaserScan(ranges=[0.5, 1.5, float("inf")], angle_min=-1.5),
    Image(width=2, height=1, data=b"\x01\x02"),
    OccupancyGrid(data=[-1, 0, 100]),
    BasicTypes(uint64_value=2**64 - 1, int64_value=-(2**63), byte_value=b"\xff", char_value=7),
    Strings(string_value="a", bounded_string_value="b"),
    Arrays(string_values=["a", "b", "c"], bool_values=[True, False, True]),
    UnboundedSequences(string_values=["x"], float64_values=[1.0, 2.0], bool_values=[True]),
    BoundedSequences(int16_values=[1, 2, 3]),
    Nested(),
    SetBool.Request(data=True),
]


@pytest.mark.parametrize("message", MESSAGES, ids=lambda m: type(m).__name__)
def test_a_message_survives(message):
    data = serialize_message(message)
    assert isinstance(data, bytes)
    assert deserialize_message(data, type(message)) == message


@pytest.mark.parametrize(
    ("message", "data"),
    [
        (String(data="hi"), "00010000 03000000 686900"),
        (Float64(data=1.0), "00010000 000000000000f03f"),
        (Header(stamp=Time(sec=1, nanosec=2), frame_id="a"), "00010000 01000000 02000000 02000000 6100"),
    ],
)
def test_the_bytes_are_cdr(message, data):
    assert serialize_message(message) == bytes.fromhex(data)


@pytest.mark.parametrize("data", [b"", b"abc"])
def test_too_few_bytes_are_refused(data):
    with pytest.raises(RuntimeError, match="failed to deserialize ROS message"):
        deserialize_message(data, String)


@pytest.mark.parametrize("other", ["text", 1, None])
def test_what_is_no_message_is_refused(other):
    with pytest.raises(AttributeError):
        serialize_message(other)


@pytest.mark.parametrize("data", ["text", 1, None])
def test_only_bytes_are_read(data):
    with pytest.raises(TypeError):
        deserialize_message(data, String)
