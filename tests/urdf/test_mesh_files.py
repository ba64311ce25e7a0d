"""Mesh files of strangers: their textures are found as Gazebo does, and nothing of theirs ends in a traceback."""

import struct

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from coursekit.urdf import Mesh, MeshError
from coursekit.urdf.resources import find_file
from coursekit.urdf.shapes import GREY, notes_of, surfaces_of
from tests.needs import posix

DAE = """<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Z_UP</up_axis></asset>
<library_images><image id="pic"><init_from>{texture}</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>pic</init_from></surface></newparam>
<newparam sid="p"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="t"><phong><emission>{emission}</emission><diffuse><texture texture="p" texcoord="UV"/></diffuse>
</phong></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="v"><float_array id="va" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#va" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="vs"><input semantic="POSITION" source="#v"/></vertices>
<triangles count="1" material="mm"><input semantic="VERTEX" source="#vs" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="sc"><node><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="mm" target="#m"/></technique_common></bind_material></instance_geometry></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#sc"/></scene></COLLADA>"""
PLAIN, TEXTURED = "<color>0 0 0 1</color>", '<texture texture="p" texcoord="UV"/>'
RED = (1.0, 0.0, 0.0, 1.0)


@pytest.fixture
def model(tmp_path):
    """A model's folder with a mesh that has a texture, and where that lies."""

    def make(texture="../materials/textures/red.png", lies="materials/textures/red.png", emission=PLAIN):
        folder = tmp_path / "crate"
        (folder / "meshes").mkdir(parents=True)
        (folder / "model.config").write_text("<model/>")
        if lies:
            place = folder / lies
            place.parent.mkdir(parents=True, exist_ok=True)
            Image.new("RGB", (8, 8), (255, 0, 0)).save(place)
        mesh = folder / "meshes" / "crate.dae"
        mesh.write_text(DAE.format(texture=texture, emission=emission))
        return Mesh(str(mesh))

    return make


@pytest.mark.parametrize(
    ("texture", "lies"),
    [
        ("../materials/textures/red.png", "materials/textures/red.png"),
        ("red.png", "materials/textures/red.png"),
        ("file:///home/bob/art/red.png", "materials/textures/red.png"),
        ("C:\\art\\red.png", "meshes/red.png"),
        ("model://crate/materials/textures/red.png", "materials/textures/red.png"),
    ],
)
@pytest.mark.parametrize("emission", [PLAIN, TEXTURED])
def test_a_texture_is_found_where_gazebo_finds_it(model, capfd, monkeypatch, tmp_path, texture, lies, emission):
    monkeypatch.setenv("GZ_SIM_RESOURCE_PATH", str(tmp_path))
    mesh = model(texture, lies, emission)
    assert [surface.colour for surface in surfaces_of(mesh)] == [RED] and not notes_of(mesh)
    assert "Traceback" not in "".join(capfd.readouterr())


def test_a_texture_in_a_folder_of_gazebo_s_path_is_found(model, monkeypatch, tmp_path):
    (tmp_path / "media" / "materials" / "textures").mkdir(parents=True)
    Image.new("RGB", (4, 4), (255, 0, 0)).save(tmp_path / "media" / "materials" / "textures" / "red.png")
    monkeypatch.setenv("GAZEBO_RESOURCE_PATH", str(tmp_path / "media"))
    assert surfaces_of(model("red.png", None))[0].colour == RED


@pytest.mark.parametrize("emission", [PLAIN, TEXTURED])
def test_a_texture_that_is_missing_is_drawn_plain_and_told_in_one_line(model, capfd, emission):
    mesh = model("none.png", None, emission)
    assert len(surfaces_of(mesh)) == 1
    (note,) = notes_of(mesh)
    assert "texture 'none.png' is not found" in note and "\n" not in note
    assert "Traceback" not in "".join(capfd.readouterr())


def test_a_texture_that_is_none_is_drawn_plain(model, tmp_path):
    mesh = model()
    (tmp_path / "crate" / "materials" / "textures" / "red.png").write_bytes(b"\x89PNG\r\n\x1a\n" + b"x" * 100)
    assert "cannot be read" in notes_of(mesh)[0] and len(surfaces_of(mesh)) == 1


def test_nothing_outside_of_the_model_is_read(model, tmp_path):
    Image.new("RGB", (4, 4), (255, 0, 0)).save(tmp_path / "secret.png")
    mesh = model("../../secret.png", None)
    assert surfaces_of(mesh)[0].colour != RED and "not found" in notes_of(mesh)[0]


def test_a_link_out_of_the_model_is_not_followed(model, tmp_path):
    Image.new("RGB", (4, 4), (255, 0, 0)).save(tmp_path / "secret.png")
    mesh = model("red.png", None)
    (tmp_path / "crate" / "meshes" / "red.png").symlink_to(tmp_path / "secret.png")
    assert surfaces_of(mesh)[0].colour != RED


@posix("most accounts can make no links: `colcon build --symlink-install` makes none there")
def test_a_mesh_that_was_installed_as_a_link_finds_what_lies_beside_its_source(model, tmp_path):
    mesh = model()
    (tmp_path / "install").mkdir()
    (tmp_path / "install" / "crate.dae").symlink_to(mesh.filename)
    assert surfaces_of(Mesh(str(tmp_path / "install" / "crate.dae")))[0].colour == RED


def test_an_obj_without_its_materials_is_drawn_plain(tmp_path):
    obj = tmp_path / "a.obj"
    obj.write_text("mtllib gone.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n")
    assert len(surfaces_of(Mesh(str(obj)))) == 1 and "gone.mtl" in notes_of(Mesh(str(obj)))[0]
    (tmp_path / "gone.mtl").write_text("newmtl red\nKd 1 0 0\nmap_Kd nothing.png\n")
    obj.touch()
    assert surfaces_of(Mesh(str(obj)))[0].colour[1:] != GREY[1:]


def test_corners_that_are_no_numbers_and_triangles_without_corners_are_errors(tmp_path):
    stl, ply = tmp_path / "nan.stl", tmp_path / "far.ply"
    triangle = struct.pack("<12fH", *[0.0] * 3, *[float("nan")] * 9, 0)
    stl.write_bytes(b" " * 80 + struct.pack("<I", 1) + triangle)
    ply.write_text(
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n"
    )
    for file in (stl, ply):
        with pytest.raises(MeshError, match=file.name):
            surfaces_of(Mesh(str(file)))


@pytest.mark.parametrize(
    "uri", ["package://[x/a.stl", "http://[::1/a.stl", "model://", "model://none/a.stl", "file://", "\0"]
)
def test_a_uri_that_is_none_is_an_error(uri):
    with pytest.raises(MeshError):
        find_file(uri)


KINDS = ["stl", "dae", "obj", "ply", "glb", "off"]


@pytest.mark.parametrize("kind", KINDS)
@settings(max_examples=60, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(data=st.data())
def test_a_damaged_file_is_a_mesh_or_an_error(tmp_path, capfd, kind, data):
    text = trimesh.creation.box((1, 1, 1)).export(file_type=kind)
    sound = bytearray(text.encode() if isinstance(text, str) else text)
    for place, byte in data.draw(st.lists(st.tuples(st.integers(0, len(sound) - 1), st.integers(0, 255)), max_size=6)):
        sound[place] = byte
    file = tmp_path / f"x{abs(hash(bytes(sound)))}.{kind}"
    file.write_bytes(sound[: data.draw(st.integers(0, len(sound)))])
    try:
        assert all(np.isfinite(surface.vertices).all() for surface in surfaces_of(Mesh(str(file))))
    except MeshError as error:
        assert file.name in str(error)
    finally:
        file.unlink()
    assert "Traceback" not in "".join(capfd.readouterr())


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("a.ply", b"ply\nformat binary_little_endian 1.0\nelement vertex 2000000000\nproperty float x\nend_header\n"),
        ("a.gltf", b'{"asset":{"version":"2.0"},"accessors":[{"count": 800000000,"componentType":5126,"type":"VEC3"}]}'),
    ],
)
def test_a_file_that_promises_billions_of_corners_is_an_error_before_memory_is_taken(tmp_path, name, data):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(MeshError, match="promises"):
        surfaces_of(Mesh(str(tmp_path / name)))
