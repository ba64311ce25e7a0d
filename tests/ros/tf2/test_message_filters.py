"""Messages of several topics by their time."""

import random

import pytest
from message_filters import ApproximateTimeSynchronizer, Cache, SimpleFilter, Subscriber, TimeSynchronizer
from rclpy.time import Time
from std_msgs.msg import Header, String


class Message:
    """Anything with a stamped header."""

    def __init__(self, seconds, data=0):
        self.header = Header(stamp=Time(seconds=seconds).to_msg())
        self.data = data


def collected(synchronizer):
    got = []
    synchronizer.registerCallback(lambda *messages: got.append(messages))
    return got


def test_equal_stamps_belong_together():
    left, right = SimpleFilter(), SimpleFilter()
    got = collected(TimeSynchronizer([left, right], 10))
    one, two = Message(1), Message(1)
    left.signalMessage(one)
    right.signalMessage(Message(2))
    assert got == []
    right.signalMessage(two)
    assert got == [(one, two)]


def test_only_the_newest_wait_for_a_partner():
    left, right = SimpleFilter(), SimpleFilter()
    got = collected(TimeSynchronizer([left, right], 1))
    left.signalMessage(Message(1))
    left.signalMessage(Message(2))
    right.signalMessage(Message(1))
    assert got == []


@pytest.mark.parametrize("count", range(1, 10))
def test_near_stamps_belong_together_in_any_order(count):
    dice = random.Random(count)
    left, right = SimpleFilter(), SimpleFilter()
    got = collected(ApproximateTimeSynchronizer([left, right], count, 0.1))
    ours = [Message(second) for second in range(count)]
    theirs = [Message(second + dice.uniform(0, 0.09)) for second in range(count)]
    for message in dice.sample(ours, count):
        left.signalMessage(message)
    for message in dice.sample(theirs, count):
        right.signalMessage(message)
    assert set(got) == set(zip(ours, theirs, strict=True))


def test_stamps_too_far_apart_do_not():
    left, right = SimpleFilter(), SimpleFilter()
    got = collected(ApproximateTimeSynchronizer([left, right], 5, 0.1))
    left.signalMessage(Message(1.0))
    right.signalMessage(Message(1.2))
    assert got == []


def test_three_filters_give_three_messages():
    filters = [SimpleFilter() for _ in range(3)]
    got = collected(ApproximateTimeSynchronizer(filters, 5, 0.1))
    messages = [Message(1.0), Message(1.05), Message(1.02)]
    for each, message in zip(filters, messages, strict=True):
        each.signalMessage(message)
    assert got == [tuple(messages)]


def test_messages_without_a_header_count_from_their_arrival(node, session):
    left, right = SimpleFilter(), SimpleFilter()
    got = collected(ApproximateTimeSynchronizer([left, right], 5, 0.1, allow_headerless=True))
    one, two = String(data="a"), String(data="b")
    left.signalMessage(one)
    right.signalMessage(two)
    assert got == [(one, two)]
    refusing = collected(ApproximateTimeSynchronizer([left, right], 5, 0.1))
    left.signalMessage(one)
    right.signalMessage(two)
    assert refusing == []


def test_arguments_of_registering_are_passed_on():
    source, got = SimpleFilter(), []
    assert source.registerCallback(lambda *args: got.append(args), "extra", 5) == 0
    source.signalMessage("m")
    assert got == [("m", "extra", 5)]


def test_a_cache_keeps_the_last_messages(node):
    cache = Cache(SimpleFilter(), 5)
    passed = collected(cache)
    assert cache.getLast() is None and cache.getOldestTime() is None
    messages = [Message(second) for second in range(7)]
    for message in messages:
        cache.add(message)

    def at(seconds):
        return Time.from_msg(Time(seconds=seconds).to_msg())

    assert cache.getInterval(at(2.5), at(4)) == messages[3:5]
    assert cache.getElemAfterTime(at(3.5)) is messages[4] and cache.getElemAfterTime(at(9)) is None
    assert cache.getElemBeforeTime(at(3.5)) is messages[3] and cache.getElemBeforeTime(at(1)) is None
    assert cache.getOldestTime() == at(2) and cache.getLastestTime() == cache.getLatestTime() == at(6)
    assert cache.getLast() is messages[6] and len(passed) == 7


def test_a_cache_takes_messages_without_a_header_only_if_allowed(node):
    refusing, allowing = Cache(SimpleFilter(), 5), Cache(SimpleFilter(), 5, allow_headerless=True)
    for cache in (refusing, allowing):
        cache.add(String(data="x"))
    assert refusing.getLast() is None and allowing.getLast() == String(data="x")


def test_a_subscriber_is_a_subscription(node):
    import rclpy

    subscriber, got = Subscriber(node, String, "chatter"), []
    assert subscriber.getTopic() == "chatter" and subscriber.topic_name == "/chatter"
    subscriber.registerCallback(got.append)
    Subscriber(node, String, "other", 5)
    Subscriber(node, String, "third", qos_profile=5)
    node.create_publisher(String, "chatter", 10).publish(String(data="hi"))
    rclpy.spin_once(node, timeout_sec=1.0)
    assert got == [String(data="hi")]


def test_stamps_may_be_plain_numbers() -> None:
    class Numbered:
        def __init__(self, stamp: int) -> None:
            self.header = type("Header", (), {"stamp": stamp})()

    one, other = SimpleFilter(), SimpleFilter()
    pairs: list[tuple[int, int]] = []
    synchronizer = TimeSynchronizer([one, other], 3)
    synchronizer.registerCallback(lambda a, b: pairs.append((a.header.stamp, b.header.stamp)))
    for stamp in (2, 0, 1):
        one.signalMessage(Numbered(stamp))
    for stamp in (1, 2, 0):
        other.signalMessage(Numbered(stamp))
    assert sorted(pairs) == [(0, 0), (1, 1), (2, 2)]
