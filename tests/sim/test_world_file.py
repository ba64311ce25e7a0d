"""World files: what is read, and what is said about wrong ones."""

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from coursekit.geometry.plane import Pose2D
from coursekit.sim import Lidar, WorldError, load_world, read_world

WORLDS = sorted((Path(__file__).parents[2] / "maps" / "worlds").glob("*.yaml"))


@pytest.mark.parametrize("path", WORLDS, ids=lambda path: path.stem)
def test_the_course_s_worlds_are_closed_and_have_room_for_a_robot(path):
    world = load_world(path)
    assert world.name == path.stem and world.file == str(path)
    seen = Lidar(range_max=100.0).look(world.cut(0.18), world.start)
    if world.things:
        assert np.isfinite(seen).all() and seen.min() > 0.25
    for place in (Pose2D(0.0, 0.0), Pose2D(0.5, 0.5)):  # where spawn_entity.py and the course put robots
        assert world.name == "empty" or Lidar().look(world.cut(0.18), place).min() > 0.2


def test_walls_have_their_thickness_and_meet_at_corners():
    world = read_world("world: w\nwalls: [{name: r, points: [[0,0],[4,0],[4,4],[0,4]], closed: true, thickness: 0.2}]")
    seen = Lidar(beams=720, angle_max=6.27, range_max=100.0).look(world.cut(0.5), Pose2D(2, 2))
    assert seen.min() == pytest.approx(1.9) and seen.max() == pytest.approx(1.9 * 2**0.5, rel=1e-3)
    assert len(world.cut(2.5).edges) == 0, "nothing is above the walls"


def test_copies_stand_one_step_further_each():
    world = read_world("world: w\nboxes: [{name: b, center: [0,0], size: [1,1], repeat: {count: 3, step: [2, 0.5]}}]")
    assert [thing.place[:2] for thing in world.things] == [(0, 0), (2, 0.5), (4, 1)]
    assert [thing.name for thing in world.things] == ["b_1", "b_2", "b_3"]


def test_boxes_with_mass_move_and_doors_hang_on_hinges():
    world = read_world(
        "world: w\nboxes: [{name: b, center: [0,0], size: [1,1], mass: 2}]\n"
        "doors: [{name: d, hinge: [3,0], mass: 4, open: 0.5}]"
    )
    assert world.thing("b").mass == 2.0
    hinge = world.thing("d").hinge
    assert hinge.lower == pytest.approx(-0.5) and hinge.upper == pytest.approx(np.pi / 2 - 0.5)


WRONG = {
    "polygons: [{name: p, points: [[0,0],[1,0]]}]": "polygon 'p': has 2 different points",
    "polygons: [{name: p, points: [[0,0],[1,0],[2,0]]}]": "has no area",
    "polygons: [{name: p, points: [[0,0],[1,1],[1,0],[0,1]]}]": "crosses itself: edge 1 meets edge 3",
    "polygons: [{name: p, points: [[0,0],[1,1],[1,.nan]]}]": "'points' is nan",
    "circles: [{name: c, center: [0,0], radius: -1}]": "'radius' is -1",
    "circles: [{name: c, center: [0,0]}]": "has no 'radius'",
    "circles: [{name: c, center: [0,0], radius: 1, hight: 2}]": "Did you mean 'height'?",
    "boxs: []": "Did you mean 'boxes'?",
    "boxes: [{name: b, center: [0,0], size: [1,0]}]": "'size' is",
    "boxes: [{name: b, center: [0,0], size: [1,1], texture: woood}]": "Did you mean 'wood'?",
    "boxes: [{name: b, center: [0,0], size: [1,1]}, {name: b, center: [3,0], size: [1,1]}]": "the name is taken",
    "boxes: [7]": "is no element",
    "boxes: {a: 1}": "is no list",
    "walls: [{name: w, points: [[0,0],[1,1]], closed: true}]": "at least 3 points",
    "walls: [{name: w, points: [[0,0],[0,0],[1,1]]}]": "twice in a row",
    "circles: [{name: c, center: [0,0], radius: 1, radius: 2}]": "is there twice",
    "circles: [{name: c": "is no YAML",
    "circles: [{name: c, center: [0,0], radius: 1, repeat: {count: 1e9, step: [0,0]}}]": "'count' is",
    "start: [0, x]": "'start' is 'x'",
    "a: !!python/object/apply:os.system [ls]": "is no YAML",
}


@pytest.mark.parametrize("text", WRONG)
def test_faults_are_named_with_file_place_and_cure(text):
    with pytest.raises(WorldError) as caught:
        read_world("world: w\n" + text, "yard.yaml")
    assert str(caught.value).startswith("yard.yaml") and WRONG[text] in str(caught.value) and caught.value.cure


def test_a_file_that_is_not_there_names_those_beside_it(tmp_path):
    (tmp_path / "yard.yaml").write_text("world: yard")
    with pytest.raises(WorldError, match=r"Did you mean 'yard.yaml'"):
        load_world(tmp_path / "yrd.yaml")


@settings(max_examples=150, deadline=None, derandomize=True)
@given(st.text(st.sampled_from("world: wboxesn{}[]-,&*!\n 01.#'\"|>?%@\t"), max_size=80))
def test_no_text_does_worse_than_a_world_error(text):
    try:
        read_world("world: w\n" + text)
    except WorldError as error:
        assert error.cure
