"""What the checks of chapter 2 say of ends that never meet."""

import pytest

from coursekit.grade.plan import Seen
from tests.grade.tried import verdict

TEXT, NUMBER = "std_msgs/msg/String", "std_msgs/msg/Int32"
HEARD = "subscription to /py_str_topic"
JOINED = f"subscription to /py_str_topic of type {TEXT}"


def seen(node, publishers=(), subscriptions=()):
    """A node with these ends, name to type, that says nothing."""
    given = dict(publishers), dict(subscriptions)
    ends = [{name: [{"node": node, "type": kind}] for name, kind in some.items()} for some in given]
    topics = {name: [kind] for some in given for name, kind in some.items()}
    return Seen(outputs=[""], nodes=[node], topics=topics, publishers=ends[0], subscriptions=ends[1])


@pytest.mark.parametrize(
    ("publishers", "subscriptions", "expected", "got"),
    [
        ({"/py_upper": TEXT}, {"/py_str_topic": TEXT}, "publisher on /py_upper_topic", "publishers: /py_upper"),
        ({"/py_upper_topic": TEXT}, {"/py_upper_topic": TEXT}, HEARD, "subscriptions: /py_upper_topic"),
        ({"/py_upper_topic": TEXT}, {}, HEARD, "subscriptions: none"),
        ({"/py_upper_topic": TEXT}, {"/py_str_topic": NUMBER}, JOINED, f"type: {NUMBER}"),
    ],
)
def test_of_a_relay_the_end_that_is_missing_is_told(publishers, subscriptions, expected, got):
    said = verdict("ch02.q3", seen("/py_relay_node", publishers, subscriptions))
    assert (said.expected, said.got) == (f"a {expected}", got)


def test_a_listener_of_another_type_is_told_that_it_is_never_joined():
    said = verdict("ch02.q2", seen("/py_subscriber_node", {}, {"/py_str_topic": NUMBER}))
    assert (said.got, said.points) == (f"type: {NUMBER}", 0) and "never joined" in said.cause


@pytest.mark.parametrize(
    ("publishers", "cause"),
    [
        ({}, "Was it built after the last change?"),
        ({"/mood": TEXT}, "Is there a second one?"),
        ({"/mood": TEXT, "/word": TEXT}, "They have the same type."),
    ],
)
def test_of_health_the_cause_follows_what_there_is(publishers, cause):
    assert verdict("ch02.q4", seen("/health", publishers)).cause == cause
