import pytest
from builtin_interfaces.msg import Duration as DurationMsg
from builtin_interfaces.msg import Time as TimeMsg
from rclpy.duration import Duration, Infinite


def test_seconds_and_nanoseconds_add_up():
    assert Duration(seconds=1, nanoseconds=5).nanoseconds == 1_000_000_005
    assert Duration(seconds=-0.5).nanoseconds == -500_000_000


@pytest.mark.parametrize("given", [{"seconds": 2**40}, {"nanoseconds": 2**63}, {"nanoseconds": -(2**63) - 1}])
def test_a_duration_beyond_64_bits_is_refused(given):
    with pytest.raises(OverflowError):
        Duration(**given)


def test_durations_compare():
    one, two = Duration(seconds=1), Duration(seconds=2)
    assert one == Duration(seconds=1)
    assert one != two
    assert one < two <= Duration(seconds=2)
    assert two > one >= Duration(seconds=1)


@pytest.mark.parametrize("other", [1, None, "text"])
def test_a_duration_does_not_order_with_anything_else(other):
    with pytest.raises(TypeError):
        Duration() < other  # noqa: B015


@pytest.mark.humble_only("later versions answer False")
@pytest.mark.parametrize("other", [1, None, "text"])
def test_a_duration_does_not_even_equal_anything_else(other):
    with pytest.raises(TypeError):
        Duration() == other  # noqa: B015


@pytest.mark.humble_only("later versions add durations")
def test_durations_do_not_add():
    with pytest.raises(TypeError):
        Duration() + Duration()


@pytest.mark.parametrize(
    ("seconds", "sec", "nanosec"), [(1.5, 1, 500_000_000), (-0.5, -1, 500_000_000), (0, 0, 0), (-2, -2, 0)]
)
def test_a_duration_survives_its_message(seconds, sec, nanosec):
    message = Duration(seconds=seconds).to_msg()
    assert message == DurationMsg(sec=sec, nanosec=nanosec)
    assert Duration.from_msg(message) == Duration(seconds=seconds)


@pytest.mark.parametrize("other", [1, None, TimeMsg()])
def test_only_a_duration_message_is_a_duration(other):
    with pytest.raises(TypeError, match="Must pass a builtin_interfaces"):
        Duration.from_msg(other)


def test_its_text():
    assert str(Duration(seconds=1.5)) == "1500000000 nanoseconds"
    assert repr(Duration(nanoseconds=-5)) == "Duration(nanoseconds=-5)"
    assert str(Infinite) == "Infinite"
    assert Infinite.nanoseconds == 2**63 - 1


def test_it_has_no_hash():
    with pytest.raises(TypeError):
        hash(Duration())
