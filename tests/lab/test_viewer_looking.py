"""A viewer's camera: moved by a hand, along with a frame, kept as views; no browser is needed."""

import math

import numpy as np
import pytest

from coursekit.lab.viewer import viewer
from coursekit.view.scene_still import Still
from tests.lab.viewer_stage import frame


def test_a_camera_that_a_hand_moved_stays_until_it_is_reset(session, page):
    panel = viewer(fixed_frame="map", displays=["Grid"], view={"distance": 9.0})
    does = page(panel)
    does("look", distance=3.0, yaw=1.0, pitch=0.5, target=[1.0, 2.0, 0.0])
    assert panel.stage.camera().distance == 3.0
    does("look", distance=math.nan, yaw=1.0, pitch=0.5, target=[1.0, 2.0, 0.0])
    does("look", distance=1.0, yaw=1.0, pitch=0.5, target=[1.0])
    assert panel.stage.camera().distance == 3.0
    does("home")
    assert panel.stage.camera().distance == 9.0


def test_a_page_gets_the_camera_again_when_it_is_put_elsewhere(session, page):
    panel = viewer(fixed_frame="map", displays=["Grid"], view={"distance": 9.0})
    does = page(panel)
    does("open")
    session.clock.sleep(0.5)
    first = next(message for message in does.heard if message["type"] == "scene")
    assert first["view"]["distance"] == 9.0 and not first["view"]["anew"]
    does("look", distance=3.0, yaw=1.0, pitch=0.5, target=[1.0, 2.0, 0.0])
    does("drawn", n=1)
    session.clock.sleep(0.5)
    assert len([message for message in does.heard if message["type"] == "scene"]) == 1, "the hand knows where it is"
    does("home")
    session.clock.sleep(0.5)
    last = [message for message in does.heard if message["type"] == "scene"][-1]
    assert last["view"]["anew"] and last["view"]["distance"] == 9.0


def test_the_camera_goes_with_a_frame(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["TF"], view={"distance": 4.0})
    does = page(panel)
    does("open")
    does("follow", frame="robot", kind="Orbit")
    session.clock.sleep(0.5)
    does("drawn", n=1)
    frame(talker, "map", "robot", 2.0, static=False)
    session.clock.sleep(0.5)
    does("drawn", n=2)
    session.clock.sleep(0.5)
    assert panel.stage.camera().target == (2.0, 0.0, 0.0)
    scenes = [message for message in does.heard if message["type"] == "scene"]
    assert scenes[-1]["follow"] == [2.0, 0.0, 0.0, 0.0]
    assert scenes[-1]["view"]["target"] == [2.0, 0.0, 0.0] and scenes[-1]["view"]["anew"], "the page looks there"
    does("drawn", n=len(scenes))
    frame(talker, "map", "robot", 5.0, static=False)
    session.clock.sleep(0.5)
    assert does.heard[-1]["follow"][0] == 5.0 or does.heard[-2]["follow"][0] == 5.0
    assert panel.stage.camera().target == (5.0, 0.0, 0.0) and panel.stage.camera().distance == 4.0
    panel.follow("")
    frame(talker, "map", "robot", 7.0, static=False)
    session.clock.sleep(0.5)
    assert panel.stage.camera().target == (5.0, 0.0, 0.0) and panel.follows() is None


def test_a_follower_turns_with_its_frame(session, talker):
    from geometry_msgs.msg import TransformStamped
    from tf2_ros import TransformBroadcaster

    def turned(yaw):
        msg = TransformStamped(child_frame_id="robot")
        msg.header.frame_id, msg.header.stamp = "map", talker.get_clock().now().to_msg()
        msg.transform.translation.x = 1.0
        msg.transform.rotation.z, msg.transform.rotation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        TransformBroadcaster(talker).sendTransform(msg)
        session.clock.sleep(0.2)
        panel.stage.update()

    panel = viewer(fixed_frame="map", displays=["TF"], view={"distance": 4.0, "yaw": 0.5})
    turned(0.0)
    panel.follow("robot", turn=True)
    turned(1.0)
    assert panel.stage.camera().yaw == pytest.approx(1.5)
    panel.follow("robot")
    turned(2.0)
    assert panel.stage.camera().yaw == pytest.approx(1.5), "an orbit keeps its heading"


def test_views_are_kept_used_and_forgotten(session, talker, page):
    frame(talker, "map", "robot", 2.0)
    panel = viewer(fixed_frame="map", displays=["Grid", "TF"])
    does = page(panel)
    does("look", distance=3.0, yaw=1.0, pitch=0.5, target=[1.0, 2.0, 0.0])
    does("view", does="save", name="near")
    panel.follow("robot")
    panel.save_view("robot")
    does("view", does="use", name="near")
    assert (panel.stage.looking.frame, panel.stage.camera().target) == ("", (1.0, 2.0, 0.0))
    panel.look("robot")
    assert (panel.stage.looking.frame, panel.stage.camera().target) == ("robot", (2.0, 0.0, 0.0))
    does("view", does="use", name="rbot")
    assert "Did you mean robot?" in panel.shown()["told"]
    does("view", does="forget", name="near")
    assert panel.views == ["robot"]
    with pytest.raises(LookupError, match="There are: robot"):
        panel.look("near")


def test_from_straight_above_what_is_high_is_as_large_as_what_is_low(session, page):
    panel = viewer(fixed_frame="map", displays=["Grid"], view={"distance": 4.0, "pitch": 0.3, "target": [1.0, 2.0, 0.0]})
    does = page(panel)
    does("open")
    does("follow", frame="", kind="TopDownOrtho")
    camera = panel.stage.camera()
    assert camera.flat and camera.pitch == pytest.approx(math.pi / 2) and camera.target == (1.0, 2.0, 0.0)
    still = Still(camera, 640, 400)
    low, high, ahead = still._pixels(camera.seen(np.array([[2.0, 2.0, 0.0], [2.0, 2.0, 1.0], [1.0, 3.0, 0.0]])))
    assert np.abs(low - high).max() < 0.01 * np.abs(low - [640, 400]).max(), "height moves nothing"
    assert low[0] > 640 and low[1] == pytest.approx(400), "x is to the right"
    assert ahead[1] < 400 and ahead[0] == pytest.approx(640), "y is up"
    session.clock.sleep(0.5)
    assert [message for message in does.heard if message["type"] == "scene"][-1]["view"]["flat"]
    does("view", does="save", name="above")
    does("home")
    assert not panel.stage.camera().flat
    does("view", does="use", name="above")
    assert panel.stage.camera().flat and panel.stage.config.views["above"]["type"] == "TopDownOrtho"
