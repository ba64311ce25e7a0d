"""SDF 1.7 to 1.10: frames, nested names, merged includes; the poses are what libsdformat makes of them."""

import numpy as np
import pytest

from coursekit.nodes.gazebo.sdf_world import load_sdf
from coursekit.urdf import UrdfError

BASE = """<sdf version="1.9"><model name="base"><link name="b"><pose>0 0 0.1 0 0 0</pose></link>
<frame name="top" attached_to="b"><pose>0 0 1 0 0 0</pose></frame></model></sdf>"""
WORLD = """<sdf version="1.10"><world name="w"><plugin filename="gz-sim-physics-system" name="gz::sim::systems::Physics"/>
<frame name="corner"><pose degrees="true">1 2 0 0 0 90</pose></frame>
<model name="robot"><pose relative_to="corner">1 0 0 0 0 0</pose>
<include merge="true"><uri>model://base</uri><pose>0 0 0.5 0 0 0</pose></include>
<include><uri>model://base</uri><name>second</name><pose>0 1 0 0 0 0</pose></include>
<link name="head"><pose relative_to="top">0.2 0 0 0 0 0</pose></link>
<link name="tail"><pose relative_to="second::top"/></link>
<joint name="j" type="revolute"><parent>b</parent><child>head</child></joint>{more}</model></world></sdf>"""


@pytest.fixture
def world(tmp_path, monkeypatch):
    (tmp_path / "base").mkdir()
    (tmp_path / "base" / "model.sdf").write_text(BASE)
    monkeypatch.setenv("GZ_SIM_RESOURCE_PATH", str(tmp_path))

    def load(more=""):
        (tmp_path / "w.sdf").write_text(WORLD.format(more=more))
        return load_sdf(tmp_path / "w.sdf", newer=True)

    return load


def test_links_stand_where_their_frames_are(world):
    (robot,) = world().models
    at = {name: tuple(np.round(pose[:3, 3], 6)) for name, pose in robot.frames.items()}
    assert at["b"] == (0, 0, 0.6), "merged: a link of the model itself"
    assert at["head"] == (0.2, 0, 1.6) and at["tail"] == (0, 1, 1.1) and at["second::b"] == (0, 1, 0.1)
    assert (robot.place.x, robot.place.y, robot.place.theta) == pytest.approx((1.0, 3.0, np.pi / 2))


def test_a_frame_that_is_not_there_is_named(world):
    with pytest.raises(UrdfError, match="relative to 'second::none'|relative to 'none'"):
        world('<link name="x"><pose relative_to="second::none"/></link>')


def test_a_model_that_includes_itself_ends(world, tmp_path):
    (tmp_path / "base" / "model.sdf").write_text(BASE.replace("</model>", '<include merge="true"><uri>model://base</uri></include>'
                                                              "</model>"))  # fmt: skip
    with pytest.raises(UrdfError, match="models inside each other"):
        world()
