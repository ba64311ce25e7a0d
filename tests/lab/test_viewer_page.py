"""What a page does to a viewer's displays: adds, removes, changes, saves; no browser is needed."""

import pytest
from nav_msgs.msg import Odometry
from sensor_msgs.msg import LaserScan
from visualization_msgs.msg import Marker

from coursekit.lab.viewer import viewer
from coursekit.nodes.rviz.kinds import KINDS
from coursekit.nodes.rviz.properties import ABOUT, properties
from coursekit.view.scene_shapes import Points
from tests.lab.viewer_stage import said, scan, shapes


def rows(panel):
    return {row["name"]: row["row"] for row in panel.shown()["rows"]}


# -- displays


def test_displays_are_added_by_type_and_by_topic_and_have_names_of_their_own(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["Grid"])
    does = page(panel)
    does("add", kind="LaserScan")
    does("add", kind="LaserScan", topic="/front")
    does("add", kind="Nothing")
    assert panel.displays == ["Grid", "LaserScan", "LaserScan 2"]
    assert panel.stage.find("LaserScan 2").config.topic == "/front"
    scan(talker)
    session.clock.sleep(0.1)
    assert len(shapes(panel, "LaserScan")) == 1


def test_what_is_published_and_can_be_shown_is_offered(session, talker, page):
    panel = viewer(displays=["Grid"])
    does = page(panel)
    talker.create_publisher(LaserScan, "/front", 1)
    talker.create_publisher(Marker, "/marks", 1)
    talker.create_subscription(LaserScan, "/unheard", lambda _: None, 1)
    does("topics")
    assert does.heard[-1]["topics"] == [["/front", "LaserScan"], ["/marks", "Marker"]]


def test_every_kind_says_what_it_shows_and_what_can_be_changed(session, page):
    does = page(viewer(displays=[]))
    does("kinds")
    kinds = does.heard[-1]["kinds"]
    assert set(kinds) == set(KINDS) == set(ABOUT)
    assert [property_["name"] for property_ in kinds["LaserScan"]["properties"]][:3] == [
        "Size (m)",
        "Size (Pixels)",
        "Alpha",
    ]


def test_a_display_that_is_removed_leaves_nothing(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["Grid", "LaserScan"])
    does = page(panel)
    scan(talker)
    session.clock.sleep(0.1)
    assert shapes(panel, "LaserScan")
    does("remove", row=rows(panel)["LaserScan"])
    assert panel.displays == ["Grid"] and len(panel.stage.update().things) == 1
    assert not talker.count_subscribers("/scan")
    with pytest.raises(LookupError, match="There are: Grid"):
        panel.remove("LaserScan")


def test_a_row_keeps_its_number_when_another_goes(session, page):
    panel = viewer(displays=["Grid", "TF", "Axes"])
    does = page(panel)
    axes = rows(panel)["Axes"]
    does("remove", row=rows(panel)["TF"])
    does("switch", row=axes, on=False)
    assert panel.text().splitlines()[-1].startswith("[ ] Axes")


# -- properties


def test_a_property_changes_what_is_shown_without_a_new_message(session, talker, page):
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    does = page(panel)
    scan(talker)
    session.clock.sleep(0.1)
    assert [shape.size for shape in shapes(panel, "LaserScan")] == [0.03]
    row = rows(panel)["LaserScan"]
    for key, value in (("size", 0.2), ("color", [0, 0, 255]), ("alpha", 0.5)):
        does("property", row=row, key=key, value=value)
    (dots,) = shapes(panel, "LaserScan")
    assert dots.size == 0.2 and dots.colour == (0.0, 0.0, 1.0, 0.5) and len(dots.points) == 2
    assert panel.status("LaserScan").startswith("Ok: 1 message received")


def test_points_are_counted_in_pixels(session, talker):
    panel = viewer(fixed_frame="map", displays=[{"type": "LaserScan", "style": "Points", "size_pixels": 4}])
    scan(talker)
    session.clock.sleep(0.1)
    (dots,) = shapes(panel, "LaserScan")
    assert isinstance(dots, Points) and dots.pixels and dots.size == 4.0
    panel.change("LaserScan", style="Flat Squares")
    (dots,) = shapes(panel, "LaserScan")
    assert not dots.pixels and dots.size == 0.03


def test_what_cannot_be_is_told_and_changes_nothing(session, page):
    panel = viewer(displays=["Grid"])
    does = page(panel)
    row = rows(panel)["Grid"]
    for key, value, text in (("color", "red", "'color' cannot be 'red'"), ("colour", [1, 2, 3], "no option 'colour'")):
        does("property", row=row, key=key, value=value)
        assert text in panel.shown()["told"]
    does("property", row=row, key="alpha", value=7.0)
    assert panel.stage.find("Grid").options["alpha"] == 1.0, "within its bounds"
    assert panel.stage.find("Grid").options["color"] == [160, 160, 164]


def test_the_trail_of_an_odometry_takes_new_looks_and_a_new_length(session, talker):
    panel = viewer(fixed_frame="map", displays=["Odometry"])
    for x in range(4):
        msg = Odometry()
        msg.pose.pose.position.x = float(x)
        msg.pose.covariance[0] = 1.0
        said(talker, Odometry, "/odom", pose=msg.pose)
        session.clock.sleep(0.1)
        panel.stage.update()
    assert len(shapes(panel, "Odometry")) == 4
    panel.change("Odometry", covariance=True, keep=2)
    assert len(shapes(panel, "Odometry")) == 4, "two arrows and their doubt"
    places = sorted(thing.pose[0] for thing in panel.stage.scene.things.values())
    assert places == [2.0, 3.0]


def test_another_quality_of_service_subscribes_anew(session, talker):
    panel = viewer(fixed_frame="map", displays=["LaserScan"])
    panel.change("LaserScan", reliability="Reliable", depth=9)
    (ours,) = talker.get_subscriptions_info_by_topic("/scan")
    assert ours.qos_profile.reliability.name == "RELIABLE"
    assert panel.stage.find("LaserScan").quality.depth == 9


def other(property_, value):
    """Another value of a property."""
    choices = [choice for choice in property_.choices if choice != value]
    kinds = {"box": not value, "colour": [1, 2, 3], "choice": choices[0] if choices else value, "text": "other"}
    return kinds.get(property_.editor, 1 if property_.whole else 0.5)


@pytest.mark.parametrize("kind", KINDS)
def test_every_property_may_be_changed_while_it_is_shown(session, talker, kind):
    from coursekit.interfaces import load

    panel = viewer(fixed_frame="map", displays=[kind])
    if KINDS[kind].type and kind not in ("RobotModel", "Image"):
        type_ = load(KINDS[kind].type)
        said(talker, type_, KINDS[kind].topic)
        session.clock.sleep(0.1)
    panel.stage.update()
    for property_ in properties(kind):
        value = other(property_, panel.stage.find(kind).options[property_.key])
        panel.change(kind, **{property_.key: value})
        panel.stage.update()
        assert panel.stage.find(kind).options[property_.key] == value


# -- files


def test_what_the_page_saves_is_what_it_shows(session, page, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    panel = viewer(fixed_frame="odom", displays=["Grid", {"type": "LaserScan", "topic": "/front", "color": [1, 2, 3]}])
    does = page(panel)
    does("look", distance=3.0, yaw=1.0, pitch=0.5, target=[1.0, 2.0, 0.0])
    does("view", does="save", name="corner")
    does("save", name="mine")
    assert 'viewer("mine.rviz")' in panel.shown()["told"]
    again = viewer("mine.rviz")
    assert again.text() == panel.text() and again.views == ["corner"]
    assert again.stage.find("LaserScan").options["color"] == [1, 2, 3]
    assert again.stage.camera().target == (1.0, 2.0, 0.0)
    does("save", name="none/mine.rviz")
    assert "No such file" in panel.shown()["told"]
