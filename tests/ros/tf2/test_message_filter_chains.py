"""Filters one after another, filters for changes, and messages in the order of their stamps."""

import pytest
import rclpy
from geometry_msgs.msg import PointStamped
from message_filters import Cache, Chain, InputAligner, SimpleFilter
from message_filters.delta_filter import (
    CachedComparisonHandler,
    ComparisonFilter,
    ComparisonHandler,
    DeltaCompare,
    DeltaFilter,
    PathDeltaFilter,
)
from rclpy.duration import Duration
from rclpy.time import Time
from std_msgs.msg import Int32, String


class Plus(SimpleFilter):
    def __init__(self, text):
        super().__init__()
        self.text = text

    def add(self, text):
        self.signalMessage(text + self.text)


def stamped(milliseconds):
    message = PointStamped()
    message.header.stamp = Time(nanoseconds=milliseconds * 1_000_000).to_msg()
    return message


def test_a_connection_that_has_ended_is_not_ended_twice():
    source, got = SimpleFilter(), []
    first = source.registerCallback(got.append)
    source.registerCallback(lambda message: got.append(-message))
    source.unregisterCallback(first)
    third = source.registerCallback(lambda message: got.append(10 * message))
    source.unregisterCallback(first)
    source.unregisterCallback(99)
    source.signalMessage(1)
    assert got == [-1, 10]
    assert third != first


def test_a_chain_passes_messages_from_filter_to_filter():
    source, got = SimpleFilter(), []
    chain = Chain(source)
    chain.registerCallback(got.append)
    source.signalMessage("lost")  # there is no filter yet
    for text in "ab":
        chain.addFilter(Plus(text))
        source.signalMessage("x")
    chain.add("y")
    assert got == ["xa", "xab", "yab"]


def test_a_chains_filters_are_counted_from_0():
    chain, one, two = Chain(), Plus("a"), Plus("b")
    chain.addFilter(one)
    chain.addFilter(two)
    assert (chain.getFilter(0), chain.getFilter(1)) == (one, two)
    for index in (2, -1):
        with pytest.raises(KeyError):
            chain.getFilter(index)


@pytest.mark.parametrize("make", [Chain, lambda source: DeltaFilter([], source)])
def test_one_input_is_enough(make):
    with pytest.raises(RuntimeError, match="already has an input"):
        make(SimpleFilter()).connectInput(SimpleFilter())


def test_only_changes_of_the_given_fields_pass():
    source, got = SimpleFilter(), []
    changes = PathDeltaFilter(["point.x", "header.frame_id"], source)
    changes.registerCallback(lambda message: got.append((message.point.x, message.header.frame_id, message.point.y)))
    for x, frame, y in [(0, "a", 0), (0, "a", 1), (1, "a", 2), (1, "b", 3), (1, "b", 4), (0, "a", 5)]:
        message = PointStamped()
        message.point.x, message.point.y, message.header.frame_id = float(x), float(y), frame
        source.signalMessage(message)
    assert got == [(0, "a", 0), (1, "a", 2), (1, "b", 3), (0, "a", 5)]


def test_a_filter_for_changes_is_given_messages_by_add_too():
    changes = DeltaFilter(field_getters=[lambda message: message.data])
    cache = Cache(changes, cache_size=5, allow_headerless=True)
    for text in "aab":
        changes.add(String(data=text))
    assert [message.data for message in cache.cache_msgs] == ["a", "b"]


def test_fields_that_are_not_there_or_not_comparable_are_refused():
    path = PathDeltaFilter(["point.w"])
    path.add(PointStamped())  # the first has nothing to differ from
    with pytest.raises(RuntimeError, match=r"Point has no field 'w' \(of 'point.w'\)"):
        path.add(PointStamped())
    with pytest.raises(TypeError, match="cannot be compared"):
        DeltaCompare([]).do_fields_fit([1], [2])


def test_own_rules_determine_what_passes():
    class Rises(CachedComparisonHandler):
        def __init__(self):
            super().__init__()
            self._field_getters = [lambda message: message.data]

        def do_fields_fit(self, field_a, field_b):
            return field_b > field_a

    got = []
    rising = ComparisonFilter(Rises())
    rising.registerCallback(lambda message: got.append(message.data))
    for number in (1, 0, 3, 2, 4):
        rising.add(Int32(data=number))
    assert got == [1, 3, 4]
    for call in (ComparisonHandler().message_fits, lambda _: ComparisonHandler().do_fields_fit(1, 2)):
        with pytest.raises(NotImplementedError):
            call(Int32())


class Aligned:
    """An aligner of inputs with a message every 4 ms, and what it passed on: inputs and milliseconds."""

    def __init__(self, count, timeout_ms=1000, period_ms=4):
        self.sources = [SimpleFilter() for _ in range(count)]
        self.aligner = InputAligner(Duration(nanoseconds=timeout_ms * 1_000_000), *self.sources)
        self.got = []
        for index in range(count):
            self.aligner.registerCallback(index, self.take, index)
            self.aligner.setInputPeriod(index, Duration(nanoseconds=period_ms * 1_000_000))

    def take(self, message, index):
        self.got.append((index, Time.from_msg(message.header.stamp).nanoseconds // 1_000_000))

    def give(self, *messages):
        for index, milliseconds in messages:
            self.sources[index].signalMessage(stamped(milliseconds))
        self.aligner.dispatchMessages()
        got, self.got = self.got, []
        return got


def test_messages_come_in_the_order_of_their_stamps():
    aligned = Aligned(3)
    messages = [(0, 5), (2, 2), (0, 1), (1, 3), (2, 6), (1, 7)]
    assert aligned.give(*messages) == sorted(messages, key=lambda message: message[1])


def test_a_message_waits_for_an_input_that_is_due_before_it():
    aligned = Aligned(2)
    assert aligned.give((0, 1), (1, 2), (0, 5), (0, 9)) == [(0, 1), (1, 2), (0, 5)]
    assert aligned.aligner.getQueueStatus(0).queue_size == 1
    assert aligned.give((1, 6)) == [(1, 6), (0, 9)]


def test_an_input_that_stays_silent_is_no_longer_waited_for():
    aligned = Aligned(2, timeout_ms=10)
    assert aligned.give((1, 1), (0, 2), (0, 6)) == [(1, 1), (0, 2)]  # the other input is due at 5
    assert aligned.give((0, 14)) == []
    assert aligned.give((0, 15)) == [(0, 6), (0, 14), (0, 15)]
    assert not aligned.aligner.getQueueStatus(1).active
    assert aligned.give((1, 16), (0, 19)) == [(1, 16), (0, 19)]
    assert aligned.aligner.getQueueStatus(1).active


def test_late_messages_are_dropped_and_counted():
    aligned = Aligned(1)
    assert aligned.give((0, 5)) == [(0, 5)]
    assert aligned.give((0, 4), (0, 5)) == [(0, 5)]
    status = aligned.aligner.getQueueStatus(0)
    assert (status.msgs_processed, status.msgs_dropped, status.queue_size) == (2, 1, 0)


def test_new_inputs_replace_the_old_ones_and_their_callbacks():
    aligned = Aligned(2)
    aligned.aligner.connectInput(filters=aligned.sources[:1])
    assert len(aligned.aligner.event_queues) == 1
    assert aligned.give((0, 1), (1, 2)) == []
    aligned.aligner.registerCallback(0, aligned.take, 0)
    assert aligned.give((0, 2), (1, 3)) == [(0, 2)]
    aligned.aligner.disconnectAll()
    assert aligned.give((0, 3)) == []


def test_a_timer_passes_messages_on(node):
    aligned = Aligned(1)
    aligned.aligner.setName("one")
    aligned.aligner.setupDispatchTimer(node, Duration(nanoseconds=1_000_000))
    aligned.sources[0].signalMessage(stamped(1))
    while not aligned.got:
        rclpy.spin_once(node)
    assert (aligned.aligner.getName(), aligned.got) == ("one", [(0, 1)])
