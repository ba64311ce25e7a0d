"""Whatever a stranger's file is or holds, each reader says so in its own words, at once, and with nothing else."""

import os
import tracemalloc
from itertools import pairwise

import pytest

from coursekit.bag.errors import BagError
from coursekit.bag.reader import BagReader
from coursekit.files import read_bytes
from coursekit.interfaces import InterfaceError, UnknownInterface, find_definition, parse_file
from coursekit.nav.map_error import MapError
from coursekit.nav.map_file import load_map
from coursekit.nodes.gazebo.model_paths import find_mesh, find_model
from coursekit.nodes.gazebo.world_lookup import open_world
from coursekit.nodes.rviz.config_file import read as read_view
from coursekit.rcl.parameter_file import ParameterFileError
from coursekit.rcl.parameter_file import read as read_parameters
from coursekit.sim import load_world
from coursekit.sim.errors import WorldError
from coursekit.urdf import MeshError, UrdfError, load
from coursekit.urdf.model import Mesh
from coursekit.urdf.shapes import mesh_of
from tests.needs import ON_WINDOWS, posix

URDF = '<robot name="r"><link name="a"><visual><geometry><mesh filename="{}"/></geometry></visual></link></robot>'
SDF = '<sdf version="1.6"><world name="w">{}</world></sdf>'
READERS = {
    "map": (load_map, "yaml", MapError),
    "world": (load_world, "yaml", WorldError),
    "sdf world": (open_world, "world", (WorldError, UrdfError)),
    "urdf": (load, "urdf", UrdfError),
    "xacro": (load, "xacro", UrdfError),
    "view": (read_view, "rviz", (ValueError, OSError)),
    "parameters": (read_parameters, "yaml", ParameterFileError),
    "message": (lambda file: parse_file("package", file), "msg", InterfaceError),
    "stl": (lambda file: mesh_of(Mesh(str(file))), "stl", MeshError),
    "dae": (lambda file: mesh_of(Mesh(str(file))), "dae", MeshError),
    "obj": (lambda file: mesh_of(Mesh(str(file))), "obj", MeshError),
}
DEEP = 30_000
TEXTS = {
    "nothing": "",
    "zeros": "\0" * 100,
    "no text": b"\xff\xfe\xfa" * 50,
    "brackets": "[" * DEEP,
    "closed brackets": "a: " + "[" * DEEP + "]" * DEEP,
    "braces": "{a: " * DEEP,
    "indents": "\n".join(" " * k + f"k{k}:" for k in range(3000)),
    "elements": "<a>" * DEEP,
    "closed elements": '<robot name="r">' + "<link>" * DEEP + "</link>" * DEEP + "</robot>",
    "laughs": "a: &a [1,1,1,1,1,1,1,1,1]\n"
    + "".join(f"{b}: &{b} [{','.join([f'*{a}'] * 9)}]\n" for a, b in pairwise("abcdefghi")),
    "entities": '<!DOCTYPE r [<!ENTITY a "ha">'
    + "".join(f'<!ENTITY {b} "{f"&{a};" * 10}">' for a, b in pairwise("abcdefghij"))
    + "]><robot name='r'>&j;</robot>",
    "outside": '<!DOCTYPE r [<!ENTITY a SYSTEM "file:///etc/passwd">]><robot name="r">&a;</robot>',
    "tag": "!!python/object/apply:os.system ['true']",
    "numbers": "resolution: " + "9" * 10_000 + "\nimage: x.pgm",
    "list": "- 1\n- 2\n",
    "word": "hello",
    "dates": "image: 2020-01-01\nresolution: .inf\norigin: [.nan, 1e999, 3]\nworld: 12:30:45\n"
    "circles: [{center: [.nan, 1], radius: -.inf}]\n",
    "wrong kinds": "world: [1]\nwalls: {a: 1}\ncircles: 5\nimage: {}\nresolution: []\n"
    "/**: {ros__parameters: [1, {a: 2}]}\ndisplays: 7\n",
    "powers": '<robot xmlns:xacro="http://x" name="r"><link name="${9**9**9}"/></robot>',
    "letters": """<robot xmlns:xacro="http://x" name="r"><link name="${'a'*3000000000}"/></robot>""",
    "rviz": "Visualization Manager:\n  Displays:\n    - Class: rviz_default_plugins/LaserScan\n      Size (m): 1e400\n"
    "      Topic: {Value: 5, Depth: 1e400}\n    - Class: rviz_default_plugins/Grid\n      Plane Cell Count: .inf\n"
    "  Views: {Current: {Class: rviz_default_plugins/Orbit, Distance: .inf, Focal Point: {X: abc}}}\n",
}


def tried(read, file, allowed):
    """What it said, '' when it could make something of the file."""
    try:
        read(file)
    except allowed as error:
        return str(error)
    return ""


@pytest.mark.parametrize("what", READERS)
@pytest.mark.parametrize("text", TEXTS)
def test_what_a_file_holds_ends_in_the_reader_s_own_words(tmp_path, what, text):
    read, ending, allowed = READERS[what]
    file = tmp_path / f"File.{ending}"
    file.write_bytes(TEXTS[text] if isinstance(TEXTS[text], bytes) else TEXTS[text].encode())
    tried(read, file, allowed)


@pytest.mark.parametrize("what", READERS)
@pytest.mark.parametrize("kind", ["device", "pipe", "folder", "huge", "missing", "long name"])
def test_what_is_no_file_is_told_at_once(tmp_path, what, kind):
    read, ending, allowed = READERS[what]
    file = tmp_path / f"File.{ending}"
    make = {
        "device": lambda: file.symlink_to("/dev/zero"),
        "pipe": lambda: os.mkfifo(file),
        "folder": file.mkdir,
        "huge": lambda: (file.touch(), os.truncate(file, 5 << 30)),
    }
    if ON_WINDOWS and kind == "pipe":
        pytest.skip("Windows: a folder holds no pipes")
    make.get(kind, lambda: None)()
    if kind == "long name":
        file = tmp_path / ("F" * 300 + f".{ending}")
    assert tried(read, file, allowed)


@posix("a folder holds no pipes, and there is no /dev")
@pytest.mark.parametrize("picture", ["/dev/zero", "F" * 5000 + ".pgm", "pipe.pgm", "a\\0b.pgm", "/"])
def test_a_map_s_picture_that_is_none_is_told(tmp_path, picture):
    os.mkfifo(tmp_path / "pipe.pgm")
    (tmp_path / "map.yaml").write_text(
        f'image: "{picture}"\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n'
    )
    with pytest.raises(MapError, match="picture"):
        load_map(tmp_path / "map.yaml")


@pytest.mark.parametrize("name", ["F" * 5000, "a/" * 3000, "a\0b", ""])
def test_names_that_no_file_has_are_not_found(name):
    with pytest.raises(UnknownInterface):
        find_definition(f"std_msgs/msg/{name}")
    for find in (find_model, find_mesh):
        for uri in (f"model://{name}", f"file:///{name}", name):
            with pytest.raises(MeshError):
                find(uri)
    with pytest.raises(UrdfError):
        list(__import__("coursekit.urdf.shapes", fromlist=["x"]).surfaces_of(Mesh(f"package://{name}/x.stl")))


@posix("a folder holds no pipes, and there is no /dev")
def test_a_bag_of_odd_files_is_told(tmp_path):
    for number, make in enumerate((os.mkfifo, lambda path: os.symlink("/dev/zero", path), os.mkdir)):
        folder = tmp_path / str(number)
        folder.mkdir()
        make(folder / "metadata.yaml")
        with pytest.raises((BagError, OSError)):
            BagReader(folder)


def test_a_small_file_takes_no_memory_for_the_largest_one(tmp_path):
    (tmp_path / "small").write_bytes(b"few bytes")
    tracemalloc.start()
    try:
        assert read_bytes(tmp_path / "small") == b"few bytes"
        assert tracemalloc.get_traced_memory()[1] < 2 << 20  # for Windows it is memory that is really there
    finally:
        tracemalloc.stop()
