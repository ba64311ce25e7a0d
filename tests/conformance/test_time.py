import pytest
from builtin_interfaces.msg import Duration as DurationMsg
from builtin_interfaces.msg import Time as TimeMsg
from rclpy.clock import ClockType
from rclpy.duration import Duration
from rclpy.time import Time

ROS, SYSTEM = ClockType.ROS_TIME, ClockType.SYSTEM_TIME


def test_seconds_and_nanoseconds_add_up():
    time = Time(seconds=1, nanoseconds=5)
    assert time.nanoseconds == 1_000_000_005
    assert time.seconds_nanoseconds() == (1, 5)
    assert time.clock_type == SYSTEM


def test_fractions_of_a_second_count():
    assert Time(seconds=1.5).nanoseconds == 1_500_000_000


@pytest.mark.parametrize("given", [{"seconds": -1}, {"nanoseconds": -1}])
def test_a_negative_time_is_refused(given):
    with pytest.raises(ValueError, match="must not be negative"):
        Time(**given)


@pytest.mark.parametrize("given", [{"seconds": 2**40}, {"nanoseconds": 2**63}])
def test_a_time_beyond_64_bits_is_refused(given):
    with pytest.raises(OverflowError):
        Time(**given)


@pytest.mark.parametrize("clock_type", ["ROS_TIME", None, 1.5])
def test_a_clock_type_is_a_clock_type(clock_type):
    with pytest.raises(TypeError):
        Time(clock_type=clock_type)


def test_times_compare():
    one, two = Time(seconds=1), Time(seconds=2)
    assert one == Time(seconds=1)
    assert one != two
    assert one < two <= Time(seconds=2)
    assert two > one >= Time(seconds=1)


@pytest.mark.parametrize("compare", ["__eq__", "__ne__", "__lt__", "__le__", "__gt__", "__ge__"])
def test_times_of_different_clocks_do_not_compare(compare):
    with pytest.raises(TypeError, match="Can't compare times with different clock types"):
        getattr(Time(seconds=1), compare)(Time(seconds=1, clock_type=ROS))


@pytest.mark.parametrize("other", [1, None, "text", Duration()])
def test_a_time_does_not_order_with_anything_else(other):
    with pytest.raises(TypeError):
        Time() < other  # noqa: B015


@pytest.mark.humble_only("later versions answer False")
@pytest.mark.parametrize("other", [1, None, "text", Duration()])
def test_a_time_does_not_even_equal_anything_else(other):
    with pytest.raises(TypeError, match="Can't compare time with object of type"):
        Time() == other  # noqa: B015


def test_a_duration_moves_a_time():
    assert Time(seconds=1) + Duration(seconds=2) == Time(seconds=3)
    assert Duration(seconds=2) + Time(seconds=1) == Time(seconds=3)
    assert Time(seconds=3) - Duration(seconds=2) == Time(seconds=1)


def test_two_times_differ_by_a_duration():
    assert Time(seconds=1) - Time(seconds=3) == Duration(seconds=-2)


def test_the_clock_type_stays():
    assert (Time(clock_type=ROS) + Duration(seconds=1)).clock_type == ROS


def test_times_of_different_clocks_have_no_difference():
    with pytest.raises(TypeError, match="Can't subtract times with different clock types"):
        Time() - Time(clock_type=ROS)


def test_no_time_is_before_zero():
    with pytest.raises(ValueError, match="Subtraction leads to negative time"):
        Time(seconds=1) - Duration(seconds=2)


def test_an_addition_beyond_64_bits_is_refused():
    with pytest.raises(OverflowError, match="Addition leads to overflow"):
        Time(nanoseconds=2**63 - 1) + Duration(nanoseconds=1)


@pytest.mark.parametrize("other", [1, 1.5, None])
def test_numbers_do_not_move_a_time(other):
    with pytest.raises(TypeError):
        Time() + other
    with pytest.raises(TypeError):
        Time() - other


def test_a_time_survives_its_message():
    message = Time(seconds=1, nanoseconds=2).to_msg()
    assert message == TimeMsg(sec=1, nanosec=2)
    assert Time.from_msg(message) == Time(seconds=1, nanoseconds=2, clock_type=ROS)
    assert Time.from_msg(message, clock_type=SYSTEM).clock_type == SYSTEM


@pytest.mark.parametrize("other", [1, None, DurationMsg()])
def test_only_a_time_message_is_a_time(other):
    with pytest.raises(TypeError, match="Must pass a builtin_interfaces"):
        Time.from_msg(other)


def test_its_text_names_the_clock():
    assert repr(Time(nanoseconds=5, clock_type=ROS)) == "Time(nanoseconds=5, clock_type=ROS_TIME)"
