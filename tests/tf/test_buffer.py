"""Lookups: by tree and time, against plain matrices, and every reason for which they fail."""

import math
import random

import numpy as np
import pytest

from coursekit.tf import (
    IDENTITY,
    ConnectivityException,
    ExtrapolationException,
    FrameBuffer,
    InvalidArgumentException,
    LookupException,
    TransformException,
)
from coursekit.tf.pose import matrix
from coursekit.tf.velocity import velocity
from tests.tf.trees import S, random_tree, times


def at(x, y=0.0, yaw=0.0):
    return x, y, 0.0, 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)


@pytest.fixture
def said():
    return []


@pytest.fixture
def buffer(said):
    return FrameBuffer(report=lambda level, text: said.append(f"{level}: {text}"))


@pytest.mark.parametrize("seed", range(12))
def test_random_trees_agree_with_plain_matrices(buffer, seed):
    data = random_tree(seed)
    newest = {}
    for parent, child, stamp, pose, static in data:
        assert buffer.set(parent, child, stamp, pose, static=static)
        newest[child] = (parent, np.array(matrix(pose)))

    def in_root(frame):
        if frame not in newest:
            return np.identity(4)
        parent, pose = newest[frame]
        return in_root(parent) @ pose

    latest = max(stamp for _, _, stamp, _, _ in data) if data else 0
    for cache in buffer.frames.values():  # all seen at one moment
        if cache is not None and not cache.static:
            buffer.set(cache.parent, cache.name, latest, cache.newest_pose)
    for a in buffer.frames:
        for b in buffer.frames:
            expected = np.linalg.inv(in_root(a)) @ in_root(b)
            assert np.allclose(matrix(buffer.lookup(a, b).pose), expected, atol=1e-9)


@pytest.mark.parametrize("seed", range(6))
def test_the_kept_path_gives_what_walking_gives(buffer, seed):
    for parent, child, stamp, pose, static in random_tree(seed):
        buffer.set(parent, child, stamp, pose, static=static)

    def outcome(a, b, time):
        try:
            return buffer.lookup(a, b, time)
        except TransformException as error:
            return type(error), str(error)

    for a in buffer.frames:
        for b in buffer.frames:
            for time in times(seed):
                buffer._paths.clear()
                walked = outcome(a, b, time)
                kept = outcome(a, b, time)
                assert kept == walked


def sample(dice):
    """One of what is broadcast: a new frame, a next sample, one out of order, another parent, nonsense."""
    child, parent = dice.choice("abc"), dice.choice(["map", "map", "map", "odom", "/map", "a"])
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
        for one in samples:
            single.set(*one)
    held = [
        {name: (cache.stamps, cache.poses, cache.parents) for name, cache in buffer.frames.items() if cache}
        for buffer in (together, single)
    ]
    assert held[0] == held[1] and together.authorities == single.authorities


def test_time_zero_is_the_newest_common_time(buffer):
    buffer.set("map", "odom", 2 * S, at(1.0))
    buffer.set("odom", "base", 1 * S, at(1.0))
    buffer.set("odom", "base", 3 * S, at(3.0))
    buffer.set_static("base", "laser", at(0.5))
    assert buffer.lookup("map", "laser") == ((3.5, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0), 2 * S)
    assert buffer.latest_common_time("map", "laser") == 2 * S
    assert buffer.lookup("base", "laser").stamp == 0
    assert buffer.lookup("base", "laser", 7 * S).stamp == 7 * S


def test_between_two_samples_it_interpolates(buffer):
    buffer.set("a", "b", 1 * S, at(0.0))
    buffer.set("a", "b", 2 * S, at(2.0, yaw=1.0))
    pose = buffer.lookup("a", "b", S + S // 2).pose
    assert pose == pytest.approx(at(1.0, yaw=0.5))


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


def test_a_frame_may_change_its_parent(buffer):
    buffer.set_static("world", "left", at(-1.0))
    buffer.set_static("world", "right", at(1.0))
    buffer.set("left", "ball", 1 * S, at(0.0))
    assert buffer.lookup("world", "ball").pose[0] == -1.0
    buffer.set("right", "ball", 2 * S, at(0.0))
    assert buffer.lookup("world", "ball").pose[0] == 1.0
    assert buffer.lookup("world", "ball", S + S // 2).pose[0] == -1.0  # nothing to interpolate between parents
    buffer.set_static("left", "ball", at(0.5))
    assert buffer.lookup("world", "ball").pose[0] == -0.5
    assert buffer.parent("ball") == "left"


def test_a_static_frame_that_is_told_anew_has_moved(buffer):
    buffer.set_static("a", "b", at(1.0))
    buffer.set_static("b", "c", at(1.0))
    assert buffer.lookup("a", "c").pose[0] == 2.0
    buffer.set_static("a", "b", at(5.0))
    assert buffer.lookup("a", "c").pose[0] == 6.0


def test_time_travel_goes_by_the_fixed_frame(buffer):
    for second in (1, 2, 3):
        buffer.set("world", "turtle1", second * S, at(float(second)))
        buffer.set("world", "turtle2", second * S, at(0.0, float(second)))
    found = buffer.lookup_full("turtle2", 3 * S, "turtle1", 1 * S, "world")
    assert (found.pose[:3], found.stamp) == ((1.0, -3.0, 0.0), 3 * S)
    assert buffer.can_full("turtle2", 3 * S, "turtle1", 1 * S, "world") == (True, "")
    can, why = buffer.can_full("turtle2", 9 * S, "turtle1", 1 * S, "world")
    assert not can and "into the future" in why


def test_a_frame_is_at_itself(buffer):
    assert buffer.lookup("nobody", "nobody", 5) == (IDENTITY, 5)
    buffer.set("a", "b", 3 * S, at(1.0))
    assert buffer.lookup("b", "b") == (IDENTITY, 3 * S)
    assert buffer.can("nobody", "nobody") == (True, "")


# -- failures, one by one


def fails(kind, text, ask):
    with pytest.raises(kind) as caught:
        ask()
    assert str(caught.value) == text and isinstance(caught.value, TransformException)


def test_unknown_frames(buffer):
    buffer.set("foo", "bar", S, at(1.0))
    text = '"baz" passed to lookupTransform argument source_frame does not exist. '
    fails(LookupException, text, lambda: buffer.lookup("foo", "baz"))
    text = '"baz" passed to lookupTransform argument target_frame does not exist. '
    fails(LookupException, text, lambda: buffer.lookup("baz", "foo"))
    text = '"baz" passed to lookupTransform argument fixed_frame does not exist. '
    fails(LookupException, text, lambda: buffer.lookup_full("foo", 0, "bar", 0, "baz"))
    why = 'Invalid frame ID "baz" passed to canTransform argument source_frame - frame does not exist'
    assert buffer.can("foo", "baz") == (False, why)


def test_names_that_no_frame_has(buffer):
    buffer.set("foo", "bar", S, at(1.0))
    start = 'Invalid argument "/foo" passed to lookupTransform argument target_frame - '
    text = start + "in tf2 frame_ids cannot start with a '/'"
    fails(InvalidArgumentException, text, lambda: buffer.lookup("/foo", "bar"))
    text = 'Invalid argument "" passed to lookupTransform argument source_frame - in tf2 frame_ids cannot be empty'
    fails(InvalidArgumentException, text, lambda: buffer.lookup("foo", ""))
    assert buffer.can("foo", "")[1].endswith("argument source_frame - in tf2 frame_ids cannot be empty")


def test_two_trees(buffer):
    buffer.set("a", "b", S, at(1.0))
    buffer.set("c", "d", S, at(1.0))
    text = (
        "Could not find a connection between 'a' and 'd' because they are not part of the same tree."
        "Tf has two or more unconnected trees."
    )
    fails(ConnectivityException, text, lambda: buffer.lookup("a", "d"))
    fails(ConnectivityException, text, lambda: buffer.lookup("a", "d", S))
    assert buffer.can("a", "d") == (False, text)


def test_times_outside_of_the_buffer(buffer):
    buffer.set("a", "b", 2 * S, at(1.0))
    end = ", when looking up transform from frame [b] to frame [a]"
    text = "Lookup would require extrapolation at time 1.000000, but only time 2.000000 is in the buffer" + end
    fails(ExtrapolationException, text, lambda: buffer.lookup("a", "b", 1 * S))
    buffer.set("a", "b", 3 * S, at(2.0))
    text = (
        "Lookup would require extrapolation into the future.  Requested time 3.500000 but the latest data is at time "
        "3.000000" + end
    )
    fails(ExtrapolationException, text, lambda: buffer.lookup("a", "b", 3 * S + S // 2))
    text = (
        "Lookup would require extrapolation into the past.  Requested time 1.500000 but the earliest data is at time "
        "2.000000" + end
    )
    fails(ExtrapolationException, text, lambda: buffer.lookup("a", "b", S + S // 2))


def test_a_loop(buffer):
    buffer.set("a", "b", S, at(1.0))
    buffer.set("b", "a", S, at(1.0))
    buffer.set("x", "y", S, at(1.0))
    with pytest.raises(LookupException, match=r"The tf tree is invalid because it contains a loop\.\nFrame b exists"):
        buffer.lookup("y", "a", S)


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


# -- the tree as text


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


def test_the_chain_of_frames(buffer):
    for parent, child in (("a", "b"), ("b", "c"), ("a", "d")):
        buffer.set(parent, child, S, at(1.0))
    assert buffer.chain("d", 0, "c", 0, "d") == ["c", "b", "a", "d"]
    assert buffer.chain("c", 0, "d", 0, "a") == ["d", "a", "b", "c"]


def test_velocity_is_distance_over_time(buffer):
    for second in range(5):
        buffer.set("parent", "child", second * S + 1, at(3.0 * second, yaw=0.1 * second))
    linear, angular = velocity(buffer, "child", "parent", "parent", (0, 0, 0), "child", 3 * S, 2 * S)
    assert linear == pytest.approx((3.0, 0.0, 0.0)) and angular == pytest.approx((0.0, 0.0, 0.1))
