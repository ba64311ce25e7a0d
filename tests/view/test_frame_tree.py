import xml.etree.ElementTree as ElementTree

import pytest

from coursekit.tf import IDENTITY, FrameBuffer
from coursekit.view.frame_tree import FrameTree

S = 10**9


@pytest.fixture
def buffer():
    frame_buffer = FrameBuffer()
    for tenth in range(1, 21):
        frame_buffer.set("map", "odom", tenth * S // 10, IDENTITY, "me")
        frame_buffer.set("odom", "base", tenth * S // 10, IDENTITY, "me")
    frame_buffer.set_static("base", "laser", IDENTITY, "me")
    frame_buffer.set_static("base", "camera", IDENTITY, "me")
    return frame_buffer


def names(tree):
    return [part.get("data-name") for part in ElementTree.fromstring(tree.svg()).iter() if part.get("data-name")]


def test_the_text_draws_the_tree(buffer):
    assert FrameTree(buffer).text().splitlines() == [
        "frames: 5 frames, 1 tree",
        "map",
        "`-- odom  10.0 Hz",
        "    `-- base  10.0 Hz",
        "        |-- camera  static",
        "        `-- laser  static",
    ]


def test_every_frame_is_in_the_picture(buffer):
    tree = FrameTree(buffer)
    assert sorted(names(tree)) == ["base", "camera", "laser", "map", "odom"]
    assert "Broadcaster: me" in FrameTree(buffer, details=True).svg()
    assert tree.png().startswith(b"\x89PNG") and tree.pdf().startswith(b"%PDF") and tree.pdf() == tree.pdf()
    bundle, _ = tree._repr_mimebundle_()
    assert bundle["text/plain"] == tree.text()


def test_two_trees_are_a_fault_with_its_cure(buffer):
    buffer.set_static("robot2/odom", "robot2/base", IDENTITY)
    tree = FrameTree(buffer)
    assert "! 2 trees that nothing joins, with the roots map, robot2/odom: " in tree.text()
    assert "Publish the pose of one root in a frame of the other." in tree.text() and "ck-cure" in tree.svg()


def test_a_loop_is_a_fault():
    buffer = FrameBuffer()
    buffer.set("a", "b", S, IDENTITY)
    buffer.set("b", "a", S, IDENTITY)
    assert "! a loop: a, b." in FrameTree(buffer).text()
    assert sorted(names(FrameTree(buffer))) == ["a", "b"]


def test_what_nobody_tells_any_more_is_marked(buffer):
    assert "! base: no node has published its pose in odom for 3.0 s" in FrameTree(buffer, 5 * S).text()
    assert "!" not in FrameTree(buffer, 3 * S).text()


def test_no_frames_are_said_to_be_none():
    tree = FrameTree(FrameBuffer())
    assert tree.text() == "frames: none. No node has published a transform on /tf or /tf_static."
    assert "No tf data received" in tree.svg()
