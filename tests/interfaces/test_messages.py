"""Message classes behave as Humble's."""

import array
import copy
import inspect
import pickle
import subprocess
import sys
import traceback

import numpy
import pytest
from builtin_interfaces.msg import Time
from example_interfaces.srv import AddTwoInts
from geometry_msgs.msg import Pose, PoseWithCovariance, Quaternion, Twist, Vector3
from rcl_interfaces.msg import Log
from sensor_msgs.msg import Image, LaserScan, RegionOfInterest
from std_msgs.msg import Header, String, UInt8MultiArray
from test_msgs.action import Fibonacci
from test_msgs.msg import (
    Arrays,
    BasicTypes,
    BoundedSequences,
    Constants,
    Defaults,
    Empty,
    Strings,
    UnboundedSequences,
)

from coursekit.interfaces import definition as d
from tests.needs import real_windows


@pytest.mark.parametrize(
    ("message", "field", "value", "text"),
    [
        (Vector3(), "x", 1, "The 'x' field must be of type 'float'"),
        (Vector3(), "x", numpy.float32(1), "The 'x' field must be of type 'float'"),
        (BasicTypes(), "int32_value", numpy.int32(1), "The 'int32_value' field must be of type 'int'"),
        (
            RegionOfInterest(),
            "height",
            -1,
            "The 'height' field must be an unsigned integer in [0, 4294967295]",
        ),
        (BasicTypes(), "int8_value", 128, "The 'int8_value' field must be an integer in [-128, 127]"),
        (
            BasicTypes(),
            "float32_value",
            1e39,
            "The 'float32_value' field must be a float in [-3.402823466e+38, 3.402823466e+38]",
        ),
        (
            BasicTypes(),
            "byte_value",
            b"ab",
            "The 'byte_value' field must be of type 'bytes' or 'ByteString' with length 1",
        ),
        (String(), "data", None, "The 'data' field must be of type 'str'"),
        (
            Strings(),
            "bounded_string_value",
            "x" * 23,
            "The 'bounded_string_value' field must be string value not longer than 22",
        ),
        (Twist(), "linear", Quaternion(), "The 'linear' field must be a sub message of type 'Vector3'"),
        (
            BoundedSequences(),
            "bool_values",
            [True] * 4,
            "The 'bool_values' field must be a set or sequence with length <= 3 "
            "and each value of type 'bool'",
        ),
        (
            LaserScan(),
            "ranges",
            array.array("d", [1.0]),
            "The 'ranges' array.array() must have the type code of 'f'",
        ),
        (
            PoseWithCovariance(),
            "covariance",
            numpy.zeros(35),
            "The 'covariance' numpy.ndarray() must have a size of 36",
        ),
        (
            PoseWithCovariance(),
            "covariance",
            numpy.zeros(36, dtype=numpy.float32),
            "The 'covariance' numpy.ndarray() must have the dtype of 'numpy.float64'",
        ),
    ],
)
def test_a_wrong_value_is_refused_in_humbles_words(message, field, value, text):
    with pytest.raises(AssertionError) as caught:
        setattr(message, field, value)
    assert str(caught.value) == text


def test_values_that_humble_takes_are_taken():
    message = BasicTypes(float64_value=numpy.float64(1.5), int32_value=True, float32_value=float("inf"))
    message.float32_value = float("nan")
    assert message.float64_value == 1.5 and message.int32_value is True


def test_lists_are_refused_by_a_float_sequences_setter_only_when_they_hold_other_types():
    scan = LaserScan(ranges=[1, 2])
    assert scan.ranges == array.array("f", [1.0, 2.0])
    with pytest.raises(AssertionError, match="each value of type 'float'"):
        scan.ranges = [1, 2]
    with pytest.raises(AssertionError):
        scan.ranges = numpy.zeros(3, dtype=numpy.float32)


def test_containers_have_the_types_of_humble():
    assert isinstance(LaserScan().ranges, array.array)
    assert isinstance(Arrays().int32_values, numpy.ndarray) and Arrays().int32_values.dtype == numpy.int32
    assert UnboundedSequences().bool_values == [] and Arrays().byte_values == [b"\0"] * 3


def test_bytes_fill_a_uint8_sequence():
    image = Image(data=b"abc")
    image.data = bytearray(b"xyz")
    assert image.data == array.array("B", b"xyz")


def test_an_array_is_kept_not_copied_by_the_setter():
    values = array.array("B", b"abc")
    message = UInt8MultiArray()
    message.data = values
    assert message.data is values


def test_unknown_names_are_refused():
    with pytest.raises(AssertionError) as caught:
        Vector3(z=1.0, q=2.0, a=1.0)
    assert str(caught.value) == "Invalid arguments passed to constructor: a, q"
    with pytest.raises(AttributeError):
        Vector3().w = 1.0


def test_repr_shows_how_to_make_it():
    assert repr(Quaternion()) == "geometry_msgs.msg.Quaternion(x=0.0, y=0.0, z=0.0, w=1.0)"
    assert repr(AddTwoInts.Request(a=1, b=2)) == "example_interfaces.srv.AddTwoInts_Request(a=1, b=2)"
    assert repr(UInt8MultiArray(data=b"\1\2")).endswith("data=[1, 2])")
    assert repr(Empty()) == "test_msgs.msg.Empty()"


def test_equality_is_by_value_and_class():
    assert Vector3(x=1.0) == Vector3(x=1.0) != Vector3(x=2.0)
    assert Vector3() != String() and Vector3() != "x"
    assert PoseWithCovariance() == PoseWithCovariance()
    other = PoseWithCovariance()
    other.covariance[7] = 1.0
    assert other != PoseWithCovariance()
    with pytest.raises(TypeError):
        hash(Vector3())


def test_constants_are_read_only_on_the_class_and_readable_on_messages():
    assert Constants.INT8_CONST == Constants().INT8_CONST == -50
    assert Log.INFO == b"\x14"
    with pytest.raises(AttributeError):
        Constants.INT8_CONST = 1
    with pytest.raises(AttributeError):
        Constants().INT8_CONST = 1


def test_defaults_can_be_asked_for():
    assert Quaternion.W__DEFAULT == 1.0 and Defaults.BYTE_VALUE__DEFAULT == b"2"
    assert Defaults().float32_value == 1.125
    assert Strings().string_value_default4 == "Hello'world!"


def test_defaults_are_not_shared():
    one, two = UnboundedSequences(), UnboundedSequences()
    one.int32_values_default.append(5)
    one.bool_values_default.append(True)
    assert (
        two.int32_values_default.tolist() == [0, 2147483647, -2147483648]
        and len(two.bool_values_default) == 3
    )
    assert Pose().position is not Pose().position


def test_types_of_fields_can_be_asked_for():
    assert PoseWithCovariance.get_fields_and_field_types() == {
        "pose": "geometry_msgs/Pose",
        "covariance": "double[36]",
    }
    assert BoundedSequences.get_fields_and_field_types()["string_values"] == "sequence<string, 3>"
    assert (
        d.NamespacedType(["geometry_msgs", "msg"], "Pose"),
        d.Array(d.BasicType("double"), 36),
    ) == PoseWithCovariance.SLOT_TYPES
    assert Vector3.__slots__ == ["_x", "_y", "_z"]
    changed = Vector3.get_fields_and_field_types()
    changed.clear()
    assert Vector3.get_fields_and_field_types()


def test_a_clone_shares_nothing_that_can_change():
    original = PoseWithCovariance()
    twin = original._clone()
    twin.pose.position.x = 1.0
    twin.covariance[0] = 1.0
    assert original == PoseWithCovariance() and type(twin) is PoseWithCovariance
    scan = LaserScan(ranges=[1.0])
    scan._clone().ranges.append(2.0)
    assert len(scan.ranges) == 1
    nested = UnboundedSequences(basic_types_values=[BasicTypes()])
    nested._clone().basic_types_values[0].bool_value = True
    assert nested.basic_types_values[0].bool_value is False


def test_copy_and_pickle_work():
    message = PoseWithCovariance(pose=Pose(position=Pose().position))
    assert copy.deepcopy(message) == message
    assert pickle.loads(pickle.dumps(Header(stamp=Time(sec=1)))) == Header(stamp=Time(sec=1))


def test_services_and_actions_are_not_instantiated():
    with pytest.raises(NotImplementedError, match=r"^Service classes can not be instantiated$"):
        AddTwoInts()
    with pytest.raises(NotImplementedError, match=r"^Action classes can not be instantiated$"):
        Fibonacci()


def test_an_action_carries_its_services_and_messages():
    goal = Fibonacci.Impl.SendGoalService.Request(goal=Fibonacci.Goal(order=3))
    assert goal.goal.order == 3 and goal.goal_id.uuid.shape == (16,)
    assert Fibonacci.Impl.GetResultService.Response().status == 0
    assert Fibonacci.Impl.FeedbackMessage().feedback == Fibonacci.Feedback()
    assert Fibonacci.Impl.CancelGoalService._TYPE_NAME == "action_msgs/srv/CancelGoal"
    assert Fibonacci.Impl.GoalStatusMessage._TYPE_NAME == "action_msgs/msg/GoalStatusArray"
    assert AddTwoInts._TYPE_NAME == "example_interfaces/srv/AddTwoInts"


def test_programs_find_type_support_where_rclpy_looks():
    for cls in (String, AddTwoInts, Fibonacci):
        cls.__class__.__import_type_support__()
        assert cls.__class__._TYPE_SUPPORT is not None


def test_the_source_is_shown_in_tracebacks():
    try:
        Vector3(x=1)
    except AssertionError:
        assert "assert isinstance(value, float)" in traceback.format_exc()
    assert "def _clone" in inspect.getsource(Vector3._clone)


def test_the_modules_of_single_interfaces_can_be_imported():
    from geometry_msgs.msg._pose import Pose as SamePose

    assert SamePose is Pose and Pose.__module__ == "geometry_msgs.msg._pose"


@real_windows("what numpy asks for and Wine lacks is added when Python starts, with numpy")
def test_numpy_is_imported_only_for_messages_that_need_it():
    code = "import sys; from geometry_msgs.msg import Twist; Twist(); print('numpy' in sys.modules)"
    assert (
        subprocess.run([sys.executable, "-c", code], capture_output=True, encoding="utf-8", check=True).stdout
        == "False\n"
    )


def test_a_wrong_name_gets_a_hint():
    import std_msgs.msg

    with pytest.raises(AttributeError, match="did you mean 'String'"):
        _ = std_msgs.msg.Sting
