"""A scene, what is sent of it, and its still picture."""

import cv2
import numpy as np
import pytest
import umsgpack

from coursekit.view.scene import HERE, Scene
from coursekit.view.scene_camera import Camera, camera_of
from coursekit.view.scene_shapes import (
    Label,
    Lines,
    Picture,
    Points,
    Triangles,
    arrow,
    ball,
    box,
    corner_normals,
    simpler,
    tube,
)
from coursekit.view.scene_still import Still
from coursekit.view.scene_wire import BLOCK, packed

RED = (1.0, 0.0, 0.0, 1.0)


def cube(size=1.0):
    return Triangles(*box(size, size, size), RED)


def test_only_what_changed_is_sent():
    scene = Scene()
    scene.put("a", "one", cube())
    scene.put("a", "two", cube())
    assert len(scene.changes().made) == 2
    scene.place("a", "one", (1.0, *HERE[1:]))
    scene.place("a", "two", HERE)
    changes = scene.changes()
    assert [thing.pose[0] for thing in changes.moved] == [1.0] and not changes.made
    assert not scene.changes()


def test_changes_that_nobody_fetches_do_not_add_up():
    scene = Scene()
    for step in range(1000):
        scene.put("a", "one", cube())
        scene.place("a", "one", (float(step), *HERE[1:]))
    changes = scene.changes()
    assert (len(changes.made), len(changes.moved), len(changes.gone)) == (1, 0, 0)


def test_a_page_that_loads_again_gets_all_and_nothing_twice():
    scene = Scene()
    scene.put("a", "one", cube())
    scene.changes()
    scene.remove("a", "one")
    scene.put("a", "two", cube())
    whole = scene.whole()
    assert len(whole.made) == 1 and not whole.gone
    assert not scene.changes()


def test_poses_travel_as_one_array_and_shapes_as_commands():
    scene = Scene()
    scene.put("a", "one", cube(), Label("one"), pose=(1.0, 2.0, 3.0, 0.0, 0.0, 0.0, 1.0))
    message, buffers = packed(scene.changes())
    assert np.frombuffer(buffers[0]).reshape(-1, BLOCK).tolist() == [[1, 1, 2, 3, 0, 0, 0, 1, 1, 1, 1]]
    assert [label["text"] for label in message["labels"]] == ["one"]
    command = umsgpack.unpackb(buffers[1])
    assert command["type"] == "set_object" and command["path"] == "/scene/1/0"
    position = command["object"]["geometries"][0]["data"]["attributes"]["position"]["array"]
    assert len(position.data) == 12 * 3 * 3 * 4


def test_every_kind_of_shape_can_be_sent():
    points = np.zeros((2, 3))
    image = np.full((2, 3, 4), 255, np.uint8)
    scene = Scene()
    colours = np.ones((2, 3))
    scene.put("a", "all", Lines(points, RED, colours), Points(points, 0.1, RED, colours), Picture(image, 3.0, 2.0))
    assert len(packed(scene.changes())[1]) == 4


def test_a_cube_keeps_its_edges_and_a_tube_is_round():
    vertices, faces = box()
    assert np.allclose(np.abs(corner_normals(vertices, faces)).max(axis=1), 1.0)
    vertices, faces = tube(0.0, 1.0, 0.5, sides=32)
    normals = corner_normals(vertices, faces).reshape(-1, 3, 3)
    side = normals[:32]
    assert np.allclose(side[:, 0, 1:], vertices[faces[:32, 0], 1:] / 0.5, atol=0.1)


def test_bodies_are_closed_and_their_faces_look_outward():
    import trimesh

    for shape in (cube(), arrow(1.0, 0.1, 0.3, 0.2, RED)):
        mesh = trimesh.Trimesh(shape.vertices, shape.faces)
        assert mesh.is_winding_consistent and mesh.volume > 0


def test_the_camera_sees_what_it_looks_at_in_the_middle():
    camera = Camera(4.0, 0.7, 0.4, (1.0, 2.0, 3.0))
    assert np.allclose(camera.seen(np.array([[1.0, 2.0, 3.0]])), [[0.0, 0.0, 4.0]])
    scene = Scene()
    scene.put("a", "one", cube(2.0), pose=(5.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0))
    assert np.allclose(camera_of(scene, ["a"]).target, (5.0, 0.0, 0.0))


def picture(scene, camera=Camera(4.0), below=()):
    data = Still(camera, 200, 160).png(scene, list(below))
    return data, cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_COLOR)


def test_near_things_cover_far_ones_and_the_picture_is_the_same_every_time():
    scene = Scene()
    scene.put("a", "far", Triangles(*box(3.0, 3.0, 3.0), (0.0, 0.0, 1.0, 1.0)), pose=(-4.0, 0, 0, 0, 0, 0, 1.0))
    scene.put("a", "near", cube())
    camera = Camera(6.0, 0.0, 0.3)
    data, image = picture(scene, camera)
    blue, _, red = (int(channel) for channel in image[80, 100])
    assert red > 100 > blue
    assert image[80, 75, 0] > 100 > image[80, 75, 2]
    assert picture(scene, camera)[0] == data


def test_what_is_behind_the_camera_is_not_drawn():
    scene = Scene()
    line = np.array([[0.0, 0.0, 0.0], [50.0, 0.0, 0.0]])
    scene.put("a", "behind", cube(), Points(line, 0.1, RED), Lines(line, RED), Label("x"), pose=(50.0, 0, 0, 0, 0, 0, 1.0))
    empty = picture(Scene(), Camera(4.0, 0.0, 0.0))[1]
    assert np.array_equal(picture(scene, Camera(4.0, 0.0, 0.0))[1], empty)


@pytest.mark.parametrize(
    ("colour", "dark_rim"), [((1.0, 1.0, 1.0, 1.0), True), ((0.9, 0.9, 0.2, 1.0), True), ((0.0, 0.6, 0.0, 1.0), False)]
)
def test_a_light_text_has_a_dark_rim(colour, dark_rim):
    scene = Scene()
    scene.put("a", "sign", Label("corridor?", colour, 0.6))
    _, image = picture(scene, Camera(4.0, 0.0, 0.3))
    assert bool(image.max(axis=2).min() < 100) is dark_rim


def test_a_map_lies_with_its_upper_row_away_from_the_origin():
    image = np.zeros((2, 2, 4), np.uint8)
    image[0] = (255, 0, 0, 255)
    image[1] = (0, 0, 255, 255)
    scene = Scene()
    scene.put("map", "map", Picture(image, 2.0, 2.0))
    seen = picture(scene, Camera(6.0, -np.pi / 2, np.pi / 2 - 0.01, (1.0, 1.0, 0.0)), ["map"])[1]
    assert seen[60, 100].tolist() == [0, 0, 255] and seen[100, 100].tolist() == [255, 0, 0]


def test_a_new_picture_takes_the_place_of_the_old_one_so_that_nothing_flickers():
    scene = Scene()
    dark, light = (Picture(np.full((4, 4, 4), shade, np.uint8), 1.0, 1.0) for shade in (0, 255))
    scene.put("map", "map", dark)
    first = scene.changes().made[0].number
    scene.put("map", "map", light)
    changes = scene.changes()
    assert (changes.gone, [(thing.number, thing.shapes) for thing in changes.made]) == ([], [(first, (light,))])
    scene.put("map", "map", Label("no map"))
    assert scene.changes().gone == [first]


def test_a_body_of_too_many_faces_becomes_simpler_and_keeps_its_shape():
    body = ball(6)
    assert simpler(body, 10**6) is body
    vertices, faces = simpler(body, 3000)
    assert 500 < len(faces) <= 3000 < len(body[1])
    np.testing.assert_allclose(np.linalg.norm(vertices, axis=1), 0.5, atol=0.02)
    assert faces.max() < len(vertices) and len(np.unique(np.sort(faces, axis=1), axis=0)) == len(faces)
