"""What is taken, sorted in, forgotten and refused, and what a store tells of it."""

import math
import random

import pytest

from coursekit.tf import IDENTITY, ConnectivityException, ExtrapolationException, FrameBuffer
from tests.tf.trees import S, at


def sample(dice):
    """One of what is broadcast: a new frame, a next sample, one out of order, another parent, nonsense."""
    child, parent = dice.choice(["a", "b", "c", "/a"]), dice.choice(["map", "map", "map", "odom", "/map", "a"])
    x = dice.choice([1.0, 2.0, 3.0, math.nan, math.inf]) if dice.random() < 0.2 else dice.random()
    pose = (x, 0.0, 0.0, 0.0, 0.0, 0.0, dice.choice([1.0, 1.0, 1.0, 0.5]))
    return parent, child, dice.randrange(1, 16) * S, pose


@pytest.mark.parametrize("seed", range(40))
def test_many_samples_at_once_are_taken_as_one_after_the_other(seed):
    dice = random.Random(seed)
    together, single = (FrameBuffer(report=lambda _level, _text: None) for _ in range(2))
    for _ in range(12):
        samples = sorted([sample(dice) for _ in range(dice.randrange(6))], key=lambda one: one[2])
        together.extend(samples)
        for arguments in samples:
            single.set(*arguments)
    held = [
        {name: (cache.stamps, cache.poses, cache.parents) for name, cache in buffer.frames.items() if cache}
        for buffer in (together, single)
    ]
    assert held[0] == held[1] and together.authorities == single.authorities


def test_older_data_is_sorted_in_and_too_old_data_is_refused(buffer, said):
    for second in (20, 12, 15):
        assert buffer.set("a", "b", second * S, at(float(second)))
    assert buffer.lookup("a", "b", 13 * S).pose[0] == 13.0
    assert not buffer.set("a", "b", 9 * S, at(0.0), "late")
    assert said == [
        "Warning: TF_OLD_DATA ignoring data from the past for frame b at time 9.000000 according to authority late\n"
        "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained"
    ]


def test_the_past_is_forgotten_after_ten_seconds(buffer):
    for second in range(1, 21):
        buffer.set("a", "b", second * S, at(float(second)))
    assert buffer.lookup("a", "b", 10 * S).pose[0] == 10.0
    with pytest.raises(ExtrapolationException, match=r"earliest data is at time 10\.000000"):
        buffer.lookup("a", "b", 9 * S)


@pytest.mark.parametrize(
    ("parent", "child", "pose", "fault"),
    [
        (
            "a",
            "a",
            IDENTITY,
            'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "a"',
        ),
        ("a", "", IDENTITY, "TF_NO_CHILD_FRAME_ID"),
        ("", "b", IDENTITY, "TF_NO_FRAME_ID"),
        ("a", "b", (math.nan, *IDENTITY[1:]), "TF_NAN_INPUT"),
        ("a", "b", (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.9), "TF_DENORMALIZED_QUATERNION"),
        ("a", "b", (0.0,) * 7, "TF_DENORMALIZED_QUATERNION"),
    ],
)
def test_bad_data_is_ignored_and_told(buffer, said, parent, child, pose, fault):
    assert not buffer.set(parent, child, S, pose, "me")
    assert said[0].startswith(f"Error: {fault}") and buffer.frames == {}


def test_a_leading_slash_is_taken_off_what_is_broadcast(buffer):
    buffer.set("/map", "/robot", S, at(1.0))
    assert buffer.lookup("map", "robot").pose[0] == 1.0


def test_all_frames_as_text(buffer):
    assert buffer.all_frames_as_yaml() == "[]"
    buffer.set("map", "robot", 1 * S, at(1.0), "me")
    buffer.set("map", "robot", 2 * S, at(1.0), "me")
    buffer.set_static("robot", "laser", at(1.0), "me")
    assert buffer.all_frames_as_string() == ("Frame robot exists with parent map.\nFrame laser exists with parent robot.\n")
    assert buffer.all_frames_as_yaml().splitlines()[:7] == [
        "robot: ",
        "  parent: 'map'",
        "  broadcaster: 'me'",
        "  rate: 2.000",
        "  most_recent_transform: 2.000000",
        "  oldest_transform: 1.000000",
        "  buffer_length: 1.000",
    ]
    assert "rate: 10000.000" in buffer.all_frames_as_yaml()
    assert '"map" -> "robot"[label="Broadcaster: me\\nAverage rate: 2.000 Hz' in buffer.all_frames_as_dot()


def test_clearing_keeps_names_and_static_frames(buffer):
    buffer.set("a", "b", S, at(1.0))
    buffer.set_static("b", "c", at(1.0))
    buffer.clear()
    assert list(buffer.frames) == ["b", "a", "c"]
    assert buffer.lookup("b", "c").pose[0] == 1.0
    with pytest.raises(ConnectivityException):
        buffer.lookup("a", "b")
