"""Shapes as triangles, and where their files are."""

import re
from pathlib import Path

import numpy as np
import pytest
import trimesh

from coursekit.urdf import Box, Cylinder, Mesh, MeshError, Sphere, load, parse
from coursekit.urdf.resources import add_package_path, find_file, find_package, package_paths, remove_package_path
from coursekit.urdf.shapes import GREY, link_surfaces, mesh_of, robot_surfaces, surfaces_of
from tests.urdf.oracle import ROBOTS

OURS = sorted(ROBOTS.glob("*.urdf"))


@pytest.fixture
def folder(tmp_path):
    """A package `parts` with a unit block as STL, OBJ and DAE."""
    meshes = tmp_path / "parts" / "meshes"
    meshes.mkdir(parents=True)
    block = trimesh.creation.box((1, 1, 1))
    for kind in ("stl", "obj", "dae"):
        block.export(meshes / f"block.{kind}")
    add_package_path(tmp_path)
    yield tmp_path
    remove_package_path(tmp_path)


@pytest.mark.parametrize("kind", ["stl", "obj", "dae"])
def test_the_scale_of_a_mesh_is_honoured(folder, kind):
    mesh = mesh_of(Mesh(f"package://parts/meshes/block.{kind}", (1.0, 2.0, -3.0)))
    np.testing.assert_allclose(mesh.extents, (1, 2, 3))
    assert mesh.volume == pytest.approx(6.0)  # also mirrored: outside stays outside


@pytest.mark.parametrize(
    ("shape", "extents"),
    [
        (Box((1.0, 2.0, 3.0)), (1, 2, 3)),
        (Cylinder(0.5, 3.0), (1, 1, 3)),
        (Sphere(0.5), (1, 1, 1)),
    ],
)
def test_shapes_have_their_size_and_their_middle(shape, extents):
    mesh = mesh_of(shape)
    np.testing.assert_allclose(mesh.extents, extents, atol=0.01)
    np.testing.assert_allclose(mesh.bounds.mean(axis=0), 0.0, atol=1e-9)
    assert mesh.is_volume


def test_a_ball_without_size_is_a_point():
    (surface,) = surfaces_of(Sphere(0.0))
    assert np.array_equal(surface.vertices, np.zeros_like(surface.vertices))


@pytest.mark.parametrize("path", OURS, ids=lambda path: path.stem)
def test_every_robot_of_the_course_can_be_drawn(path):
    robot = load(path)
    drawn = list(robot_surfaces(robot))
    assert {name for name, _ in drawn} == {link.name for link in robot.links.values() if link.visuals}
    points = np.concatenate([surface.vertices for _, surface in drawn])
    assert np.isfinite(points).all()
    if robot.root.endswith("footprint"):
        assert -0.002 < points[:, 2].min() < 0.002, "it stands on the floor"


def test_the_course_robot_has_its_parts():
    robot = load(ROBOTS / "rdk_x3_robot.urdf")
    assert robot.joint_above("base_link").origin.xyz == (0.0, 0.0, 0.0659)
    wheels = [f"{side}_{place}_joint" for side in ("left", "right") for place in ("front", "back")]
    assert [joint.name for joint in robot.moving_joints()] == wheels
    assert all(robot.joints[name].axis == (0.0, 1.0, 0.0) and robot.joints[name].type == "continuous" for name in wheels)
    assert {"laser_link", "camera_link", "camera_2_link", "imu_link"} <= robot.links.keys()
    lidar = next(block for block in robot.gazebo if block.get("reference") == "laser_link").first("sensor")
    assert lidar.tell("ray/scan/horizontal/samples") == "360"
    assert (lidar.tell("update_rate"), lidar.tell("ray/range/min"), lidar.tell("ray/range/max")) == ("10", "0.12", "10.0")


def test_the_four_robots_differ_in_colour_only():
    colours = {load(ROBOTS / f"robot{number}.urdf").materials["shell"].colour for number in range(1, 5)}
    assert len(colours) == 4
    assert len({tuple(load(ROBOTS / f"robot{number}.urdf").links) for number in range(1, 5)}) == 1


def test_a_dae_file_keeps_its_colours():
    surfaces = surfaces_of(Mesh("package://coursekit_robots/meshes/rdk_x3/camera.dae"))
    assert len({surface.colour for surface in surfaces}) == 4


def test_a_dae_file_whose_texture_is_missing_is_drawn_without_it(tmp_path):
    from coursekit.urdf.resources import find_file

    text = find_file("package://coursekit_robots/meshes/rdk_x3/camera.dae").read_text()
    broken = tmp_path / "camera.dae"
    broken.write_text(re.sub(r'(<instance_effect url=")[^"]*', r"\1#gone", text))
    whole = sum(len(surface.faces) for surface in surfaces_of(Mesh("package://coursekit_robots/meshes/rdk_x3/camera.dae")))
    assert sum(len(surface.faces) for surface in surfaces_of(Mesh(str(broken)))) == whole


def test_the_material_of_the_visual_wins():
    text = '<robot name="r"><link name="a"><visual><geometry><box size="1 1 1"/></geometry>{}</visual></link></robot>'
    assert link_surfaces(parse(text.format("")), "a")[0].colour == GREY
    red = '<material name="red"><color rgba="1 0 0 1"/></material>'
    assert link_surfaces(parse(text.format(red)), "a")[0].colour == (1.0, 0.0, 0.0, 1.0)


# -- files


def test_a_package_that_is_not_there_tells_where_it_was_looked_for(folder):
    with pytest.raises(MeshError) as caught:
        find_file("package://part/meshes/block.stl")
    text = str(caught.value)
    assert "package 'part' not found" in text and "Did you mean 'parts'?" in text
    assert all(str(path) in text for path in package_paths())
    assert "add_package_path" in text


def test_a_file_that_is_not_there_is_named_with_its_neighbours(folder):
    with pytest.raises(MeshError, match="Did you mean 'block.stl'"):
        find_file("package://parts/meshes/blok.stl")


def test_a_mesh_of_a_robot_that_is_not_there_names_the_robots_line(folder, tmp_path):
    path = tmp_path / "robot.urdf"
    path.write_text(
        '<robot name="r">\n<link name="a">\n<visual><geometry><mesh filename="no.stl"/></geometry></visual></link></robot>'
    )
    with pytest.raises(MeshError) as caught:
        link_surfaces(load(path), "a")
    assert str(caught.value).startswith(f"{path}:3: <visual> of <link name=\"a\">: 'no.stl' not found")


def test_an_added_folder_comes_first_then_the_path_then_the_workspaces(tmp_path, monkeypatch):
    for name in ("added", "listed", "prefix/share"):
        (tmp_path / name / "thing").mkdir(parents=True)
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path / "prefix"))
    assert find_package("thing") == tmp_path / "prefix/share/thing"
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "listed"))
    assert find_package("thing") == tmp_path / "listed/thing"
    add_package_path(tmp_path / "added")
    assert find_package("thing") == tmp_path / "added/thing"
    remove_package_path(tmp_path / "added")
    monkeypatch.setenv("ROS_PACKAGE_PATH", str(tmp_path / "listed" / "thing"))
    assert find_package("thing") == tmp_path / "listed/thing"


def test_a_robots_own_package_is_found_without_being_installed(tmp_path):
    (tmp_path / "mine" / "urdf").mkdir(parents=True)
    (tmp_path / "mine" / "mesh.stl").write_bytes(b"")
    assert find_file("package://mine/mesh.stl", tmp_path / "mine/urdf/r.urdf") == tmp_path / "mine/mesh.stl"


def test_file_uris_and_relative_paths(folder):
    path = folder / "parts/meshes/block.stl"
    assert find_file(f"file://{path}") == path
    assert find_file("meshes/block.stl", folder / "parts/r.urdf") == path
    with pytest.raises(MeshError, match="'http://' is not known here"):
        find_file("http://example.com/a.stl")


def test_a_folder_that_is_not_there_cannot_be_added(tmp_path):
    with pytest.raises(NotADirectoryError, match="no folder"):
        add_package_path(tmp_path / "nowhere")


@pytest.mark.parametrize(("name", "content"), [("a.stl", b"no mesh"), ("a.dae", b"<COLLADA"), ("a.txt", b"x")])
def test_a_file_that_is_no_mesh_is_said_to_be_none(tmp_path, name, content):
    (tmp_path / name).write_bytes(content)
    with pytest.raises(MeshError, match=name):
        surfaces_of(Mesh(str(tmp_path / name)))


def test_the_robots_are_a_package():
    from ament_index_python.packages import get_package_share_path

    assert get_package_share_path("coursekit_robots").samefile(ROBOTS.parent)


def test_a_third_slash_leaves_no_name_of_a_package():
    with pytest.raises(MeshError, match="'package:///turtlesim/package.xml' names no package"):
        find_file("package:///turtlesim/package.xml")


def test_a_relative_path_in_a_description_from_a_topic_is_said_to_lead_nowhere():
    with pytest.raises(MeshError, match="relative to the robot's file, and a description from '/robot_desc") as caught:
        find_file("hand.stl", Path("/robot_description"))
    assert caught.value.cure.startswith("Use package://NAME/path")


def test_the_path_of_a_mesh_that_xacro_has_yet_to_work_out_is_said_to_be_that():
    with pytest.raises(MeshError, match="Expand the file first"):
        find_file("$(arg meshes)/hand.stl")
