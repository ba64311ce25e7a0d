"""Lookups: by tree and time, against plain matrices, and every reason for which they fail."""

import random

import numpy as np
import pytest

from coursekit.geometry.pose import matrix
from coursekit.tf import (
    IDENTITY,
    ConnectivityException,
    ExtrapolationException,
    FrameBuffer,
    InvalidArgumentException,
    LookupException,
    TransformException,
)
from coursekit.tf.velocity import velocity
from tests.tf.trees import S, at, random_pose, random_tree, times


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


def answer(buffer, time):
    try:
        return buffer.lookup("f0", "f3", time)
    except TransformException as fault:
        return str(fault)


@pytest.mark.parametrize("seed", range(25))
def test_who_asks_again_and_again_gets_what_one_gets_who_asks_once(seed):
    dice = random.Random(seed)
    asked, told = FrameBuffer(report=lambda _level, _text: None), []
    for _ in range(60):
        frame, late = dice.randrange(3), dice.random() < 0.2
        now = max([stamp for _, _, stamp, _ in told], default=20 * S)
        stamp = now - dice.randrange(12 * S) if late else now + dice.randrange(S // 2)
        parent = f"f{frame}" if dice.random() < 0.97 else "f0"
        told.append((parent, f"f{frame + 1}", stamp, random_pose(dice)))
        asked.set(*told[-1])
        fresh = FrameBuffer(report=lambda _level, _text: None)
        for sample in told:
            fresh.set(*sample)
        middle = now - dice.randrange(11 * S)
        for time in (middle, middle + 1000, middle + 2000, middle):
            ours, expected = answer(asked, time), answer(fresh, time)
            assert ours == expected if isinstance(expected, str) else ours.stamp == expected.stamp
            if not isinstance(expected, str):
                assert ours.pose == pytest.approx(expected.pose, abs=1e-12)


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
    transform = buffer.lookup_full("turtle2", 3 * S, "turtle1", 1 * S, "world")
    assert (transform.pose[:3], transform.stamp) == ((1.0, -3.0, 0.0), 3 * S)
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
