"""Files in RViz's form: what is written is what RViz 2 of Humble writes, and is read back the same."""

import math

import pytest
import yaml

from coursekit.nodes.rviz.config import make_config
from coursekit.nodes.rviz.config_file import read, save
from coursekit.nodes.rviz.kinds import KINDS
from coursekit.nodes.rviz.properties import properties


def other(property_, value):
    """Another value of a property, of a kind that a file keeps."""
    choices = [choice for choice in property_.choices if choice and choice != value]
    kinds = {"box": not value, "colour": [1, 2, 3], "choice": choices[0] if choices else value, "text": "other"}
    return kinds.get(property_.editor, 4 if property_.whole else 0.25)


@pytest.mark.parametrize("kind", KINDS)
def test_every_option_of_a_kind_is_read_back(kind, tmp_path):
    display = make_config(displays=[{"type": kind, "name": "mine", "enabled": False}]).displays[0]
    display.options |= {property_.key: other(property_, display.options[property_.key]) for property_ in properties(kind)}
    if KINDS[kind].type:
        display.topic = "/elsewhere"
    if kind == "RobotModel":
        display.options |= {"reliability": "", "durability": ""}  # RViz asks for the last description, whatever a file says
    config = make_config("odom", [display])
    save(config, tmp_path / "view.rviz")
    again = read(tmp_path / "view.rviz")
    assert again.displays == [display] and again.fixed_frame == "odom"


def test_the_file_has_the_form_that_rviz_writes(tmp_path):
    front = {"type": "LaserScan", "topic": "/front", "size": 0.05, "color": [1, 2, 3]}
    shown = ["Grid", front, "RobotModel", "ParticleCloud"]
    save(make_config("map", shown, {"distance": 3.0, "pitch": math.pi / 2}), tmp_path / "view.rviz")
    manager = yaml.safe_load((tmp_path / "view.rviz").read_text())["Visualization Manager"]
    grid, scan, robot, cloud = manager["Displays"]
    assert manager["Global Options"]["Fixed Frame"] == "map"
    assert (grid["Class"], grid["Cell Size"], grid["Reference Frame"]) == ("rviz_default_plugins/Grid", 1.0, "<Fixed Frame>")
    assert (scan["Size (m)"], scan["Color"], scan["Enabled"]) == (0.05, "1; 2; 3", True)
    assert scan["Topic"] == {
        "Value": "/front", "Depth": 5, "Durability Policy": "Volatile", "History Policy": "Keep Last",
        "Reliability Policy": "Best Effort",
    }  # fmt: skip
    assert (robot["Description Source"], robot["Description Topic"]["Value"]) == ("Topic", "/robot_description")
    assert cloud["Class"] == "nav2_rviz_plugins/ParticleCloud"
    view = manager["Views"]["Current"]
    assert (view["Class"], view["Distance"], view["Target Frame"]) == ("rviz_default_plugins/Orbit", 3.0, "<Fixed Frame>")
    assert view["Pitch"] < math.pi / 2, "RViz's cameras do not look straight down"


def test_the_shape_of_an_odometry_is_one_level_deeper(tmp_path):
    save(make_config("odom", [{"type": "Odometry", "covariance": True, "shape": "Axes"}]), tmp_path / "view.rviz")
    (odometry,) = yaml.safe_load((tmp_path / "view.rviz").read_text())["Visualization Manager"]["Displays"]
    assert odometry["Shape"]["Value"] == "Axes" and odometry["Shape"]["Color"] == "255; 25; 0"
    assert odometry["Covariance"] == {"Value": True} and odometry["Keep"] == 100


@pytest.mark.parametrize("name", ["view.rviz", "view.yaml"])
def test_saved_views_and_their_frames_are_read_back(name, tmp_path):
    behind = {"yaw": 3.1, "target_frame": "base", "type": "ThirdPersonFollower"}
    views = {"above": {"distance": 3.0, "pitch": 1.2}, "behind": behind}
    config = make_config("map", ["Grid"], {"distance": 2.0, "target_frame": "base"}, views)
    save(config, tmp_path / name)
    again = read(tmp_path / name)
    assert again.view == config.view and again.views == config.views
    assert again.views["behind"]["type"] == "ThirdPersonFollower"


def test_a_view_from_straight_above_has_the_fields_that_rviz_gives_it(tmp_path):
    above = {"type": "TopDownOrtho", "distance": 6.0, "yaw": -math.pi / 2, "target": [1.0, 2.0, 0.0]}
    config = make_config("map", ["Grid"], above)
    save(config, tmp_path / "view.rviz")
    current = yaml.safe_load((tmp_path / "view.rviz").read_text())["Visualization Manager"]["Views"]["Current"]
    assert current["Class"] == "rviz_default_plugins/TopDownOrtho"
    assert (current["Scale"], current["Angle"], current["X"], current["Y"]) == (100.0, 0.0, 1.0, 2.0)
    assert "Pitch" not in current and "Focal Point" not in current
    assert read(tmp_path / "view.rviz").view == config.view and config.view["pitch"] == math.pi / 2


@pytest.mark.parametrize(
    "view, text",
    [
        ({"target": [1.0]}, "three numbers"),
        ({"distance": math.inf}, "a number that is none"),
        ({"type": "Fly"}, "there are Orbit, ThirdPersonFollower, TopDownOrtho"),
    ],
)
def test_a_view_that_cannot_be_is_refused(view, text):
    with pytest.raises(ValueError, match=text):
        make_config(view=view)
