import array

import numpy
import pytest
from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose, PoseWithCovariance, Quaternion, Twist, Vector3
from sensor_msgs.msg import Image, LaserScan
from std_msgs.msg import Bool, Byte, Char, Float32, Float64, Header, Int8, String, UInt8
from std_srvs.srv import SetBool
from test_msgs.msg import Arrays, BoundedSequences, Constants, Defaults, Strings, UnboundedSequences


def test_defaults_come_from_the_definition():
    assert Quaternion().w == 1.0
    assert (Defaults().bool_value, Defaults().float32_value, Defaults().int32_value) == (True, 1.125, -30000)
    assert String().data == ""
    assert Bool().data is False


def test_keywords_fill_fields():
    assert Vector3(x=1.0, z=3.0) == Vector3(x=1.0, y=0.0, z=3.0)


def test_an_unknown_keyword_is_refused():
    with pytest.raises(AssertionError, match="Invalid arguments passed to constructor"):
        String(text="x")


def test_an_unknown_attribute_is_refused():
    with pytest.raises(AttributeError):
        String().text = "x"


@pytest.mark.parametrize("value", [1, "1", None, numpy.float32(1), numpy.int32(1)])
def test_a_float_field_takes_floats(value):
    with pytest.raises(AssertionError, match="The 'x' field must be of type 'float'"):
        Vector3().x = value


def test_a_float_field_takes_numpys_doubles():
    vector = Vector3()
    vector.x = numpy.float64(1.5)
    assert vector.x == 1.5


@pytest.mark.parametrize("value", [1.5, "1", None])
def test_an_integer_field_takes_integers(value):
    with pytest.raises(AssertionError, match="The 'data' field must be of type 'int'"):
        Int8().data = value


@pytest.mark.parametrize(
    ("kind", "value", "reason"),
    [
        (Int8, 128, r"must be an integer in \[-128, 127\]"),
        (UInt8, -1, r"must be an unsigned integer in \[0, 255\]"),
        (UInt8, 256, r"must be an unsigned integer in \[0, 255\]"),
        (Float32, 3.5e38, "must be a float in"),
        (Char, 256, r"must be an unsigned integer in \[0, 255\]"),
    ],
)
def test_numbers_have_bounds(kind, value, reason):
    with pytest.raises(AssertionError, match=reason):
        kind().data = value


@pytest.mark.parametrize("value", [float("inf"), float("nan"), -3.4e38])
def test_a_float32_may_be_infinite(value):
    Float32().data = value
    Float64().data = value


@pytest.mark.parametrize("value", [1, "x", None])
def test_a_bool_field_takes_bools(value):
    with pytest.raises(AssertionError, match="must be of type 'bool'"):
        Bool().data = value


@pytest.mark.parametrize("value", [1, b"x", None, ["x"]])
def test_a_string_field_takes_text(value):
    with pytest.raises(AssertionError, match="must be of type 'str'"):
        String().data = value


def test_a_byte_is_one_byte():
    message = Byte()
    message.data = b"\x07"
    with pytest.raises(AssertionError):
        message.data = b"ab"
    with pytest.raises(AssertionError):
        message.data = 7


def test_a_field_that_is_a_message_takes_that_message():
    pose = Pose()
    with pytest.raises(AssertionError, match="must be a sub message of type 'Point'"):
        pose.position = Vector3()
    pose.orientation = Quaternion(x=1.0, w=0.0)
    assert pose.orientation.x == 1.0


def test_primitive_sequences_are_arrays():
    scan = LaserScan()
    assert isinstance(scan.ranges, array.array)
    assert scan.ranges.typecode == "f"
    scan.ranges = array.array("f", [1.0, 2.0])
    assert scan.ranges[1] == 2.0
    assert isinstance(LaserScan(ranges=[1.0, 2.0]).ranges, array.array)


@pytest.mark.parametrize("value", ["text", 5, [1, "a"]])
def test_a_sequence_takes_its_items(value):
    with pytest.raises(AssertionError):
        LaserScan().ranges = value


def test_bytes_are_a_sequence_of_uint8():
    image = Image()
    image.data = b"\x01\x02"
    assert list(image.data) == [1, 2]


def test_fixed_arrays_of_numbers_are_numpys():
    message = PoseWithCovariance()
    assert isinstance(message.covariance, numpy.ndarray)
    assert message.covariance.shape == (36,)
    assert message.covariance.dtype == numpy.float64
    with pytest.raises(AssertionError):
        message.covariance = numpy.zeros(35)
    with pytest.raises(AssertionError):
        message.covariance = numpy.zeros(36, dtype=numpy.float32)


def test_other_sequences_are_lists():
    assert UnboundedSequences().string_values == []
    assert isinstance(Arrays().string_values, list)
    assert len(Arrays().string_values) == 3


def test_bounded_sequences_have_a_bound():
    message = BoundedSequences()
    message.bool_values = [True, False, True]
    with pytest.raises(AssertionError):
        message.bool_values = [True] * 4


def test_bounded_strings_have_a_bound():
    message = Strings()
    message.bounded_string_value = "a" * 22
    with pytest.raises(AssertionError):
        message.bounded_string_value = "a" * 23


def test_constants_are_on_class_and_instance():
    assert Constants.BYTE_CONST == Constants().BYTE_CONST
    with pytest.raises(AttributeError):
        Constants.BYTE_CONST = b"x"


def test_messages_are_equal_by_value():
    assert Vector3(x=1.0) == Vector3(x=1.0)
    assert Vector3(x=1.0) != Vector3(x=2.0)
    assert String() != Bool()
    assert String() != ""


@pytest.mark.parametrize(
    ("message", "shown"),
    [
        (Quaternion(), "geometry_msgs.msg.Quaternion(x=0.0, y=0.0, z=0.0, w=1.0)"),
        (String(data="hi"), "std_msgs.msg.String(data='hi')"),
        (Time(sec=1), "builtin_interfaces.msg.Time(sec=1, nanosec=0)"),
        (SetBool.Request(data=True), "std_srvs.srv.SetBool_Request(data=True)"),
        (
            Twist(),
            "geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=0.0), "
            "angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=0.0))",
        ),
    ],
)
def test_messages_show_themselves(message, shown):
    assert repr(message) == shown


def test_sequences_show_as_lists():
    assert "ranges=[1.0, 2.0]" in repr(LaserScan(ranges=[1.0, 2.0]))


def test_a_service_is_no_instance():
    with pytest.raises(NotImplementedError, match="Service classes can not be instantiated"):
        SetBool()


def test_fields_and_types_are_told():
    assert String.get_fields_and_field_types() == {"data": "string"}
    assert PoseWithCovariance.get_fields_and_field_types()["covariance"] == "double[36]"
    assert Header.get_fields_and_field_types() == {"stamp": "builtin_interfaces/Time", "frame_id": "string"}


def test_defaults_are_not_shared():
    one, two = Pose(), Pose()
    one.position.x = 5.0
    assert two.position.x == 0.0
    assert PoseWithCovariance().covariance is not PoseWithCovariance().covariance


def test_slot_types_follow_the_fields():
    assert len(Header.SLOT_TYPES) == 2
    assert len(Twist.SLOT_TYPES) == 2
