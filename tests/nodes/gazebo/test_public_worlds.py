"""Worlds as they lie in other people's packages: meshes in inches, files beside files, floors, frames, nests."""

import math

import pytest

from coursekit.geometry.plane import Pose2D
from coursekit.nodes.gazebo.sdf_world import load_sdf
from coursekit.nodes.gazebo.world_lookup import find_world
from coursekit.sim import Lidar, RobotModel, Simulation

WALL = """<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="inch" meter="0.0254"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh><source id="s"><float_array count="12" id="f">100 -50 0 100 50 0 100 50 40
100 -50 40
</float_array><technique_common><accessor count="4" source="#f" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#s"/></vertices><triangles count="2"><input semantic="VERTEX" source="#v"
offset="0"/><p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="w"><node><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#w"/></scene></COLLADA>"""
MODEL = "<sdf version='1.6'><model name='{0}'><static>1</static><link name='link'>{1}</link></model></sdf>"
MESH = "<collision name='c'><geometry><mesh><uri>{}</uri><scale>1 1 1</scale></mesh></geometry></collision>"
BOX = "<collision name='c'><pose>{}</pose><geometry><box><size>{}</size></box></geometry></collision>"


def ahead(world, place=Pose2D(), height=0.3):
    return float(Lidar(beams=1, angle_max=0.0, range_max=50.0, range_min=0.0).look(world.cut(height), place)[0])


@pytest.fixture
def shop(tmp_path):
    """A package with models/NAME/model.sdf and worlds/shop.world."""

    def put(name, body):
        folder = tmp_path / "share" / "shop" / "models" / name
        (folder / "meshes").mkdir(parents=True)
        (folder / "model.sdf").write_text(MODEL.format(name, body))
        return folder

    def write(body, version="1.6"):
        file = tmp_path / "share" / "shop" / "worlds" / "shop.world"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(f"<sdf version='{version}'><world name='default'>{body}</world></sdf>")
        return load_sdf(file).world

    write.put, write.folder = put, tmp_path
    return write


@pytest.mark.parametrize("uri", ["model://wall/meshes/wall.dae", "file://models/wall/meshes/wall.dae", "meshes/wall.dae"])
def test_a_collada_mesh_says_its_unit_and_is_found_where_gazebo_finds_it(shop, uri):
    (shop.put("wall", MESH.format(uri)) / "meshes" / "wall.dae").write_text(WALL)
    nested = "<model name='w'><pose>1 0 0 0 0 0</pose><include><uri>{}</uri></include></model>"
    for address in ("model://wall", "file://models/wall"):
        loaded_world = shop(nested.format(address))
        assert loaded_world.notes == () and ahead(loaded_world) == pytest.approx(1 + 2.54)
        assert not loaded_world.thing("w").moves, "an included model that is static stays so"


def test_a_package_exports_where_its_models_and_worlds_are(shop, tmp_path, monkeypatch):
    (shop.put("wall", BOX.format("3 0 0.5 0 0 0", "1 1 1")).parents[1] / "package.xml").write_text(
        "<package><name>shop</name><export><gazebo_ros gazebo_model_path='${prefix}/models' "
        "gazebo_media_path='${prefix}'/></export></package>"
    )
    shop("")
    elsewhere = tmp_path / "mine.world"
    elsewhere.write_text("<sdf version='1.6'><world name='d'><include><uri>model://wall</uri></include></world></sdf>")
    assert "not found" in load_sdf(elsewhere).world.notes[0]
    broken = tmp_path / "share" / "broken"
    broken.mkdir()
    (broken / "package.xml").write_text("<package><export><gazebo_ros")
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    assert ahead(load_sdf(elsewhere).world) == pytest.approx(2.5)
    assert find_world("worlds/shop.world").parts[-2:] == ("worlds", "shop.world")
    assert find_world("worlds/empty.world").name == "empty.yaml"


def test_a_model_that_is_nowhere_is_listed_and_the_rest_is_there(shop):
    shop.put("wall", BOX.format("3 0 0.5 0 0 0", "1 1 1"))
    loaded_world = shop(
        "<include><uri>model://nowhere</uri></include><include><uri>model://wall</uri></include>"
        "<model name='nest'><include><uri>https://fuel.example.org/1.0/x/models/tree</uri></include></model>"
    )
    assert ahead(loaded_world) == pytest.approx(2.5)
    assert "nowhere" in loaded_world.notes[0] and "tree" in loaded_world.notes[1] and "shop.world:1" in loaded_world.notes[0]


def test_robots_stand_on_floors_and_roll_over_sills(shop):
    loaded_world = shop(
        f"<model name='slab'><static>1</static><link name='l'>{BOX.format('0 0 -0.01 0 0 0', '20 20 0.02')}</link></model>"
        f"<model name='stage'><static>1</static><link name='l'>{BOX.format('0 0 0.05 0 0 0', '9 9 0.1')}</link></model>"
        f"<model name='sill'><static>1</static><link name='l'>{BOX.format('0.6 0 0 0 0 0', '0.1 9 0.03')}</link></model>"
        f"<model name='kerb'><static>1</static><link name='l'>{BOX.format('2 0 0.05 0 0 0', '0.1 9 0.1')}</link></model>"
    )
    simulation = Simulation(loaded_world)
    robot = simulation.spawn(RobotModel("robot"))
    robot.command(0.5)
    simulation.advance(6.0)
    assert robot.place.x == pytest.approx(1.95 - 0.15, abs=0.02) and list(robot.contacts) == ["kerb"]
    simulation.remove("slab")
    assert "slab" not in simulation.names()


def test_models_may_stand_relative_to_others_and_on_one_of_their_frames(shop):
    loaded_world = shop(
        "<frame name='corner'><pose>0 0 0 0 0 1.5707963267948966</pose></frame>"
        f"<model name='a'><static>1</static><pose relative_to='corner'>3 0 0 0 0 0</pose><link name='l'>"
        f"{BOX.format('0 0 0.5 0 0 0', '1 1 1')}</link></model>"
        f"<model name='b' placement_frame='end'><static>1</static><pose relative_to='a'>0 -4 0 0 0 0</pose>"
        f"<frame name='end'><pose>1 0 0 0 0 0</pose></frame><link name='l'>{BOX.format('0 0 0.5 0 0 0', '1 1 1')}</link>"
        "</model>", "1.9"
    )  # fmt: skip
    assert ahead(loaded_world, Pose2D(0, 0, math.pi / 2)) == pytest.approx(2.5)
    assert ahead(loaded_world, Pose2D(0, 2)) == pytest.approx(3.5)


def test_nests_in_nests_keep_links_of_the_same_name_apart(shop):
    shop.put("post", BOX.format("0 0 0.5 0 0 0", "0.2 0.2 1"))
    row = "<include><uri>model://post</uri><pose>{} 0 0 0 0 0</pose></include>"
    loaded_world = shop(f"<model name='yard'><model name='row'>{row.format(2)}{row.format(4)}</model></model>")
    assert ahead(loaded_world) == pytest.approx(1.9) and ahead(loaded_world, Pose2D(3, 0)) == pytest.approx(0.9)


def test_loose_things_rest_on_the_floor_or_on_what_they_stand_on(shop):
    shape = BOX.format("0 0 0 0 0 0", "0.4 0.4 0.4")
    box = "<model name='{}'><pose>2 0 {} 0 0 0</pose><link name='l'>" + shape + "</link></model>"
    table = BOX.format("0 0 0.7 0 0 0", "1 1 0.04") + BOX.format("0.4 0.4 0.35 0 0 0", "0.05 0.05 0.7")
    loaded_world = shop(
        box.format("upper", 0.6) + box.format("lower", 0.2) + box.format("flying", 3.0).replace("<pose>2 0", "<pose>6 0")
        + f"<model name='table'><static>1</static><pose>-2 0 0 0 0 0</pose><link name='l'>{table}</link></model>"
        + box.format("lunch", 0.93).replace("<pose>2 0", "<pose>-2 0")
    )  # fmt: skip
    lows = {thing.name: round(thing.parts[0].low, 3) for thing in loaded_world.things}
    assert lows == {"upper": 0.4, "lower": 0.0, "flying": 0.0, "table": 0.68, "lunch": 0.72}
    simulation = Simulation(loaded_world)
    simulation.advance(1.0)
    assert simulation.pose_of("upper") == simulation.pose_of("lower"), "nothing is shoved aside"
