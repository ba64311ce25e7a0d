"""Direct lines between sessions of one user on one computer: short messages take them, Zenoh carries all others."""

import os
import socket
import stat
import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st
from std_msgs.msg import String

from coursekit.core.qos import KEEP_ALL, TRANSIENT_LOCAL, Qos
from coursekit.net import direct
from coursekit.net.direct import LONGEST, SETTLE_SECONDS, DirectLines, Line, frame, read_frame
from coursekit.net.receiving import Receiver
from coursekit.net.wire.attachment import Attachment
from coursekit.systems.runtime_folder import folder
from coursekit.systems.user_socket import listen_at
from tests.needs import posix

from .sides import LIMIT, Inbox
from .test_topics import heard_by, listener, matched, talker

pytestmark = posix("there are no Unix sockets")


@pytest.fixture
def carried(monkeypatch):
    """The lengths of all messages that lines carried."""
    lengths, send = [], Line.send

    def counted(line, data):
        lengths.append(len(data))
        return send(line, data)

    monkeypatch.setattr(Line, "send", counted)
    return lengths


def pair(side, **options):
    """A publisher on one side, and the inbox of its listener on the other."""
    one, two = side(), side()
    publisher, inbox = talker(one, **options), Inbox(listener(two, **options))
    matched(one, publisher)
    heard_by(two, inbox.source)
    return one, two, publisher, inbox


def told(inbox, count):
    return [inbox.take()[0].data for _ in range(count)]


def test_short_messages_take_a_line_and_come_once_in_order(side, carried):
    _, _, publisher, inbox = pair(side)
    for number in range(30):
        publisher.publish(String(data=str(number)))
    assert told(inbox, 30) == [str(number) for number in range(30)] and inbox.source.take() is None
    assert len(carried) == 30


def test_after_a_long_message_zenoh_carries_the_topic_so_that_nothing_overtakes(side, carried):
    _, _, publisher, inbox = pair(side)
    texts = ["a", "b" * LONGEST, "c", "d"]
    for text in texts:
        publisher.publish(String(data=text))
    assert [text[:1] for text in told(inbox, 4)] == ["a", "b", "c", "d"] and len(carried) == 1


def test_a_session_that_reads_its_line_late_still_gets_the_messages_in_order(side, carried, monkeypatch):
    """It reads the first message after the second one has come through Zenoh, or when the sender has waited for it."""
    zenoh_was_first, hear = threading.Event(), Receiver._hear
    monkeypatch.setattr(Receiver, "_hear", lambda *came: (hear(*came), zenoh_was_first.set()))
    late = lambda *parts: (zenoh_was_first.wait(SETTLE_SECONDS / 2), read_frame(*parts))[1]  # noqa: E731
    monkeypatch.setattr(direct, "read_frame", late)
    _, _, publisher, inbox = pair(side)
    texts = ["a", "b" * LONGEST, "c"]
    for text in texts:
        publisher.publish(String(data=text))
    assert [text[:1] for text in told(inbox, 3)] == ["a", "b", "c"] and len(carried) == 1


def test_a_session_that_no_longer_answers_is_waited_for_once():
    here, there = socket.socketpair()
    line = Line(here, threading.Event())
    with there:
        line.settle()
        assert not line.send(b"closed")


@pytest.mark.parametrize("qos", [Qos(depth=5, durability=TRANSIENT_LOCAL), Qos(history=KEEP_ALL)])
def test_what_is_latched_or_never_dropped_takes_no_line(side, carried, qos):
    _, _, publisher, inbox = pair(side, qos=qos)
    publisher.publish(String(data="all"))
    assert told(inbox, 1) == ["all"] and carried == []


def test_a_listener_that_no_line_reaches_has_zenoh_carry_the_topic_for_all(side, carried):
    one, _, publisher, inbox = pair(side)
    far = side(begin=False)
    far.link.direct.close()  # as on another computer, or in the lab of another user
    far.link.begin()
    other = Inbox(listener(far))
    heard_by(far, other.source)
    matched(one, publisher, 2)
    publisher.publish(String(data="to both"))
    assert told(inbox, 1) == told(other, 1) == ["to both"] and carried == []


def test_nothing_goes_past_a_link_that_is_gone(side):
    one, _, publisher, inbox = pair(side)
    one.link._change(False)
    publisher.publish(String(data="lost"))
    one.link._change(True)
    publisher.publish(String(data="there again"))
    assert told(inbox, 1) == ["there again"]


def test_who_joined_over_another_address_is_reached_over_it(tmp_path, monkeypatch):
    """A weak link is such an address, and is meant to be felt."""
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(tmp_path))
    near, weak = DirectLines("tcp/a:1", "1a", print), DirectLines("tcp/b:1", "1b", print)
    assert near.to(["1b"]) == () and near.to([]) == () and len(near.to(["1a"])) == 1
    for lines in (near, weak):
        lines.close()


def test_only_this_user_can_call_and_nothing_is_left_behind(side):
    one, two, *_ = pair(side)
    paths = [end.link.direct._path for end in (one, two)]
    for path in paths:
        assert stat.S_IMODE(os.stat(path).st_mode) == 0o600 and path.parent == folder()
    for end in (one, two):
        end.link.close()
    assert not any(path.exists() for path in paths)
    assert not [thread.name for thread in threading.enumerate() if thread.name == "coursekit-direct" and not _ends(thread)]


def test_what_a_killed_session_left_is_removed_and_who_listens_is_left_alone(tmp_path, monkeypatch):
    monkeypatch.setenv("COURSEKIT_RUNTIME_DIR", str(tmp_path))
    dead, new = folder() / "net-dead", folder() / "net-new"
    for path in (dead, new):
        listen_at(path).close()
    alive = DirectLines("tcp/a:1", "1a", print)
    for path in (dead, alive._path):
        os.utime(path, (0, 0))
    other = DirectLines("tcp/a:1", "1b", print)
    assert not dead.exists() and new.exists() and len(other.to(["1a"])) == 1
    for lines in (alive, other):
        lines.close()


def _ends(thread):
    thread.join(LIMIT)
    return not thread.is_alive()


def test_a_session_that_is_gone_costs_no_message_of_the_others(side, carried):
    one, _, publisher, inbox = pair(side)
    third = side()
    Inbox(listener(third))
    matched(one, publisher, 2)
    publisher.publish(String(data="to both"))
    assert len(carried) == 2
    third.link.direct.close()  # killed: its announcements are still there
    publisher.publish(String(data="and on"))
    assert told(inbox, 2) == ["to both", "and on"]


def test_a_session_that_does_not_read_loses_messages_and_holds_nobody_up():
    here, there = socket.socketpair()
    line, message = Line(here, threading.Event()), frame("/chatter", "std_msgs/msg/String", bytes(1000), bytes(33))
    for _ in range(300):
        assert line.send(message)
    here.close()
    with there.makefile("rb") as stream:
        came = stream.read()
    assert 0 < len(came) < 300 * len(message) and len(came) % len(message) == 0
    assert not line.send(message)


@given(st.binary(max_size=400))
def test_what_a_line_brings_is_a_message_or_is_refused(data):
    framed = frame("/chatter", "std_msgs/msg/String", b"hello", Attachment(1, 2, bytes(16)).data())
    assert read_frame(framed[6:], (8, 19, 5)) == ("/chatter", "std_msgs/msg/String", b"hello", Attachment(1, 2, bytes(16)))
    for body in (data, framed[6:39] + data):
        try:
            name, type_name, payload, _ = read_frame(body, (2, 3, 4))
        except ValueError:
            continue
        assert len(payload) == 4 and len(name) <= 2 and len(type_name) <= 3
