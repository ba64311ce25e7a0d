"""BufferCore behaves as the C++ binding does."""

import pytest
import tf2_py
from geometry_msgs.msg import Transform, TransformStamped
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_py import BufferCore, ExtrapolationException, LookupException, TransformException


def stamped(parent, child, seconds=0.0, x=2.0):
    msg = TransformStamped(child_frame_id=child)
    msg.header.frame_id, msg.header.stamp = parent, Time(seconds=seconds).to_msg()
    msg.transform.translation.x = x
    return msg


@pytest.fixture
def core():
    buffer_core = BufferCore()
    assert buffer_core.set_transform(stamped("bar", "foo", 1.0), "unittest") is None
    buffer_core.set_transform(stamped("bar", "foo", 2.0, 4.0), "unittest")
    return buffer_core


def test_a_lookup_gives_what_was_set(core):
    assert core.lookup_transform_core("bar", "foo", Time(seconds=2)) == stamped("bar", "foo", 2.0, 4.0)
    assert core.lookup_transform_core("bar", "foo", Time(seconds=1.5).to_msg()).transform.translation.x == 3.0
    assert core.lookup_transform_core(target_frame="foo", source_frame="bar", time=Time()).transform.translation.x == -4.0


def test_a_result_is_a_message_of_its_own(core):
    first = core.lookup_transform_core("bar", "foo", Time())
    first.transform.translation.x = 99.0
    assert core.lookup_transform_core("bar", "foo", Time()).transform.translation.x == 4.0


def test_can_transform_gives_a_number_and_a_reason(core):
    assert core.can_transform_core("foo", "bar", Time(seconds=1.5)) == (1, "")
    can, why = core.can_transform_core("foo", "bar", Time(seconds=2.5))
    assert can == 0 and "extrapolation into the future" in why
    can, why = core.can_transform_full_core("foo", Time(), "bar", Time(seconds=0.5), "bar")
    assert can == 1
    assert core.can_transform_full_core("foo", Time(), "bar", Time(), "baz")[0] == 0


def test_static_transforms_hold_at_all_times():
    core = BufferCore(Duration(seconds=1.0))
    core.set_transform_static(stamped("bar", "foo"), "unittest")
    assert core.can_transform_core("bar", "foo", Time(seconds=0.5)) == (1, "")
    assert core.lookup_transform_core("bar", "foo", Time(seconds=7)).header.stamp.sec == 7


def test_the_full_lookup_joins_two_times(core):
    transform = core.lookup_transform_full_core("foo", Time(seconds=2), "foo", Time(seconds=1), "bar")
    assert transform.transform.translation.x == -2.0 and transform.header.stamp.sec == 2


def test_exceptions_have_tf2s_names(core):
    assert issubclass(tf2_py.TimeoutException, TransformException)
    assert f"{LookupException.__module__}.{LookupException.__name__}" == "tf2.LookupException"
    with pytest.raises(ExtrapolationException):
        core.lookup_transform_core("bar", "foo", Time(seconds=9))
    with pytest.raises(LookupException, match='"nowhere" passed to get_latest_common_time does not exist'):
        core.get_latest_common_time("bar", "nowhere")


@pytest.mark.parametrize("time", [5, None, "now"])
def test_what_is_no_time_is_refused(core, time):
    with pytest.raises(TypeError, match="time must have sec and nanosec, or nanoseconds"):
        core.lookup_transform_core("bar", "foo", time)
    with pytest.raises(TypeError, match="duration must have"):
        BufferCore(5)


def test_what_is_no_name_is_refused(core):
    with pytest.raises(TypeError, match="argument 2 must be str, not NoneType"):
        core.lookup_transform_core("bar", None, Time())


def test_what_is_no_transform_is_refused(core):
    class Fake:
        header = TransformStamped().header
        child_frame_id = "x"
        transform = Transform

    with pytest.raises(TypeError, match="translation must have members x, y, z"):
        core.set_transform(Fake(), "me")


def test_the_frames_are_listed(core):
    assert core._frameExists("foo") and not core._frameExists("baz")
    assert core._getFrameStrings() == ["foo", "bar"]
    assert "digraph G {" in core._allFramesAsDot() and "sec old" in core._allFramesAsDot(Time(seconds=5))
    assert core._chain("bar", Time(), "foo", Time(), "bar") == ["foo", "bar"]
    assert "Frame foo exists with parent bar." in core.all_frames_as_string()
    assert "parent: 'bar'" in core.all_frames_as_yaml()
    assert core.get_latest_common_time("bar", "foo") == Time(seconds=2)


def test_clear_forgets(core):
    core.clear()
    assert core.can_transform_core("bar", "foo", Time())[0] == 0


def test_velocity(core):
    linear, _ = core.lookupVelocityCore("foo", "bar", Time(seconds=1.5), Duration(seconds=0.5))
    assert linear[0] == pytest.approx(2.0)
