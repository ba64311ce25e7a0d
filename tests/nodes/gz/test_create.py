"""`create`: its command line, and models that name files of packages."""

import pytest

from coursekit.nodes.gazebo.sdf_world import load_sdf, read_entity
from coursekit.nodes.gz.create import arguments

MODEL = """<sdf version="1.8"><model name="cart"><link name="body"><collision name="c"><geometry><box>
<size>0.4 0.2 0.2</size></box></geometry></collision></link></model></sdf>"""
WORLD = """<sdf version="1.8"><world name="w"><plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>
<model name="spot"><include merge="true"><uri>package://depot/models/cart</uri></include></model></world></sdf>"""


def test_words_that_it_does_not_know_are_left_out_as_gflags_does():
    told, rest = arguments(["-name", "cube", "-x", "1", "-r", "0", "-p", "0", "-Y", "3.14", "-topic", "/robot_description"])
    assert (told.name, told.x, told.Y, told.topic) == ("cube", 1.0, 3.14, "/robot_description")
    assert rest == ["-r", "0", "-p", "0"]


def test_a_number_that_is_none_ends_it(capsys):
    with pytest.raises(SystemExit):
        arguments(["-x", "far"])
    assert "invalid float value: 'far'" in capsys.readouterr().err


@pytest.mark.parametrize("beside", [False, True])
def test_a_model_is_found_by_its_package(tmp_path, monkeypatch, beside):
    folder = tmp_path / "share" / "depot" / "models" / "cart"
    folder.mkdir(parents=True)
    (folder / "model.sdf").write_text(MODEL)
    if beside:
        index = tmp_path / "share" / "ament_index" / "resource_index" / "packages"
        index.mkdir(parents=True)
        (index / "depot").touch()
        monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    else:
        monkeypatch.setenv("GZ_SIM_RESOURCE_PATH", str(tmp_path / "share"))
    (tmp_path / "w.sdf").write_text(WORLD)
    (spot,) = load_sdf(tmp_path / "w.sdf", newer=True).models
    assert set(spot.frames) == {"body"} and not spot.notes


def test_the_sun_and_the_ground_of_the_web_are_there_and_others_of_it_are_told(tmp_path):
    web = "<include><uri>https://fuel.gazebosim.org/1.0/OpenRobotics/models/{}</uri></include>"
    models = "".join(web.format(name) for name in ("Sun", "Ground Plane", "ground%20plane", "Urban Station"))
    (tmp_path / "w.sdf").write_text(WORLD.split("<model")[0] + models + "</world></sdf>")
    world = load_sdf(tmp_path / "w.sdf", newer=True)
    assert [model.name for model in world.models] == ["sun", "ground_plane", "ground_plane_0"]
    (note,) = world.world.notes
    assert "Urban Station' is on the web" in note


def test_how_a_wheel_rubs_is_no_word_to_the_student():
    rubs = "<collision><surface><friction><ode><mu>1.5</mu></ode></friction></surface></collision>"
    robot = f"<robot name='r'><link name='wheel'/><gazebo reference='wheel'>{rubs}</gazebo></robot>"
    assert not read_entity(robot, "", None, newer="w").notes
