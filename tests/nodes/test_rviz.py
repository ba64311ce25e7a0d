"""rviz2: its configuration files, and the node without a notebook."""

from pathlib import Path

import pytest
from ament_index_python import get_package_share_directory

from coursekit.nodes.rviz.config import Config, display_config, make_config
from coursekit.nodes.rviz.config_file import read, save
from coursekit.processes.executables import find
from coursekit.processes.session import Session

RVIZ = """
Visualization Manager:
  Displays:
    - {Class: rviz_default_plugins/Grid, Name: Floor, Enabled: false, Cell Size: 0.5, Color: 10; 20; 30}
    - Class: rviz_common/Group
      Name: Sensors
      Displays:
        - {Class: rviz_default_plugins/LaserScan, Name: Front, Topic: {Value: /front/scan}, Size (m): 0.05}
    - {Class: rviz_default_plugins/RobotModel, Name: R1, TF Prefix: r1, Description Topic: {Value: /r1/robot_description}}
    - {Class: rviz_default_plugins/InteractiveMarkers, Name: Hands}
  Global Options: {Fixed Frame: odom}
  Views: {Current: {Class: rviz_default_plugins/Orbit, Distance: 4, Yaw: 1, Pitch: 0.5, Focal Point: {X: 1, Y: 2, Z: 0}}}
"""


def test_an_rviz_file_gives_the_displays_that_are_known_and_lists_the_others(tmp_path):
    file = tmp_path / "saved.rviz"
    file.write_text(RVIZ)
    config = read(file)
    assert config.fixed_frame == "odom"
    floor, front, robot = config.displays
    assert (floor.kind, floor.name, floor.enabled, floor.options["cell_size"]) == ("Grid", "Floor", False, 0.5)
    assert floor.options["color"] == [10, 20, 30]
    assert (front.topic, front.options["size"]) == ("/front/scan", 0.05)
    assert (robot.topic, robot.options["tf_prefix"]) == ("/r1/robot_description", "r1")
    assert config.skipped == ["Hands (rviz_default_plugins/InteractiveMarkers)"]
    assert config.view == {"distance": 4.0, "yaw": 1.0, "pitch": 0.5, "target": [1.0, 2.0, 0.0]}


NAV2 = """
Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/RobotModel
      Name: RobotModel
      Description Topic: {Depth: 5, Durability Policy: Volatile, Reliability Policy: Reliable, Value: robot_description}
    - Class: rviz_default_plugins/LaserScan
      Name: Scan
      Color Transformer: Intensity
      Decay Time: 2
      Style: Points
      Size (m): 0.5
      Topic: {Depth: 7, Durability Policy: Volatile, Reliability Policy: Best Effort, Value: scan}
    - Class: rviz_default_plugins/PointCloud2
      Name: Voxels
      Style: Boxes
      Size (m): 0.05
      Topic: voxels
    - {Class: nav2_rviz_plugins/ParticleCloud, Name: Swarm, Topic: {Value: particle_cloud, Reliability Policy: Best Effort}}
    - Class: rviz_default_plugins/Odometry
      Name: Wheels
      Shape: {Value: Arrow, Color: 1;2;3, Alpha: 0.5, Shaft Length: 2}
      Covariance: {Value: true, Position: {Value: true, Alpha: 0.3}}
      Keep: 3
      Topic: {Value: /odom}
    - {Class: rviz_default_plugins/PoseWithCovariance, Name: Amcl, Shape: Axes, Axes Length: 0.3, Topic: {Value: /amcl_pose}}
    - {Class: rviz_default_plugins/Polygon, Name: Footprint, Color: 25; 255; 0, Topic: {Value: local_costmap/footprint}}
    - {Class: rviz_default_plugins/Map, Name: Map, Topic: {Durability Policy: Transient Local, Value: /map}}
    - {Class: rviz_default_plugins/Axes, Name: Axes, Reference Frame: <Fixed Frame>, Length: 0.5, Radius: 0.05}
    - {Class: moveit_rviz_plugin/MotionPlanning, Name: Plan}
"""


def test_what_navigations_file_says_of_topics_and_looks_is_taken_over(tmp_path):
    file = tmp_path / "nav2.rviz"
    file.write_text(NAV2)
    config = read(file)
    robot, scan, voxels, swarm, wheels, amcl, footprint, grid, axes = config.displays
    assert (robot.topic, robot.options["durability"]) == ("/robot_description", "")
    assert [scan.options[key] for key in ("depth", "reliability", "durability")] == [7, "Best Effort", "Volatile"]
    assert (scan.options["decay_time"], scan.options["color_transformer"]) == (2, "Intensity")
    assert (scan.options["style"], scan.options["size_pixels"]) == ("Points", 3), "that style counts in pixels"
    assert (voxels.topic, voxels.options["style"], voxels.options["size"]) == ("/voxels", "Boxes", 0.05)
    assert (swarm.kind, swarm.options["reliability"]) == ("ParticleCloud", "Best Effort")
    assert [wheels.options[key] for key in ("shape", "color", "alpha", "shaft_length")] == ["Arrow", [1, 2, 3], 0.5, 2]
    assert (wheels.options["covariance"], wheels.options["keep"]) == (True, 3)
    assert (amcl.options["shape"], amcl.options["axes_length"]) == ("Axes", 0.3)
    assert (footprint.topic, footprint.options["color"]) == ("/local_costmap/footprint", [25, 255, 0])
    assert grid.options["durability"] == "Transient Local"
    assert (axes.topic, axes.options["reference_frame"], axes.options["length"]) == ("", "", 0.5)
    assert config.skipped == ["Plan (moveit_rviz_plugin/MotionPlanning)"]
    save(config, tmp_path / "ours.yaml")
    assert read(tmp_path / "ours.yaml").displays == config.displays


def test_a_namespaced_rviz_listens_in_its_namespace_and_where_it_is_remapped_to(tmp_path):
    (tmp_path / "nav2.rviz").write_text(NAV2)
    words = ["-d", str(tmp_path / "nav2.rviz"), "--ros-args", "-r", "__ns:=/r1", "-r", "/map:=map"]
    with Session(virtual=True).use() as session:
        process = session.start_executable(find("rviz2", "rviz2"), words, name="rviz2")
        session.clock.sleep(1.0)
        assert {"/r1/scan", "/r1/map", "/odom"} <= set(session.graph(0).subscriptions)
        process.interrupt()
        process.wait(2.0)
    assert "LaserScan): /r1/scan" in process.output


def test_a_display_whose_topic_cannot_be_is_off_and_told(tmp_path):
    file = tmp_path / "odd.rviz"
    file.write_text(RVIZ.replace("/front/scan", "/front scan"))
    with Session(virtual=True).use() as session:
        process = session.start_executable(find("rviz2", "rviz2"), ["-d", str(file)], name="rviz2")
        session.clock.sleep(1.0)
        process.interrupt()
        assert process.wait(2.0) == 0
    assert "Front: Error subscribing: Invalid topic name" in process.output


def test_what_is_saved_is_read_back_and_is_small(tmp_path):
    config = make_config("map", ["Grid", {"type": "LaserScan", "topic": "/s", "size": 0.1}], {"distance": 3})
    config.displays[0].enabled = False
    save(config, tmp_path / "v.yaml")
    assert read(tmp_path / "v.yaml") == config
    assert "- {type: LaserScan, topic: /s, size: 0.1}" in (tmp_path / "v.yaml").read_text().splitlines()


@pytest.mark.parametrize(
    "given, text",
    [
        ("LaserScn", "Did you mean 'LaserScan'"),
        ({"type": "Grid", "cellsize": 1.0}, "Did you mean 'cell_size'"),
        ({"type": "Grid", "cell_size": "big"}, "cannot be 'big'"),
        ({"type": "Grid", "color": [1, 2]}, "'color' cannot be"),
        ({"topic": "/scan"}, "is no display"),
    ],
)
def test_what_is_not_known_is_refused_with_what_there_is(given, text):
    with pytest.raises(ValueError, match=text):
        display_config(given)


@pytest.mark.parametrize(
    "text",
    [
        "- a list",
        "{{",
        "displays: 3",
        "fixed: odom",
        "view: 4",
        "[" * 3000,
        "Visualization Manager: 4",
        "Visualization Manager: {Displays: &a [{Class: c/Group, Displays: *a}]}",
        "Visualization Manager: {Displays: &a [{Class: c/Group, Displays: *a}, {Class: x/Grid}]}",
        "Visualization Manager: {Displays: [{Class: x/Grid}], Global Options: 4}",
    ],
)
def test_a_file_that_is_no_configuration_is_named(tmp_path, text):
    file = tmp_path / "bad.yaml"
    file.write_text(text)
    with pytest.raises(ValueError, match=r"bad\.yaml cannot be read"):
        read(file)


def test_an_empty_configuration_shows_nothing():
    assert make_config() == Config()


def test_without_a_notebook_it_tells_what_it_would_show_and_what_is_missing(tmp_path):
    save(make_config("odom", ["Grid", "LaserScan /front"]), tmp_path / "v.yaml")
    with Session(virtual=True).use() as session:
        process = session.start_executable(find("rviz2", "rviz2"), ["-d", str(tmp_path / "v.yaml")], name="rviz2")
        session.clock.sleep(3.0)
        assert {"/tf", "/tf_static", "/front"} <= set(session.graph(0).subscriptions)
        process.interrupt()
        assert process.wait(2.0) == 0
    assert "Fixed frame: odom" in process.output
    assert "LaserScan: /front [sensor_msgs/msg/LaserScan]" in process.output
    assert "LaserScan: no node publishes /front" in process.output


@pytest.mark.parametrize(("words", "node"), [([], "/rviz"), (["--ros-args", "-r", "__node:=eyes"], "/eyes")])
def test_it_logs_as_rviz2_whatever_its_node_is_called(words, node):
    with Session(virtual=True).use() as session:
        process = session.start_executable(find("rviz2", "rviz2"), words, name="rviz2")
        session.clock.sleep(1.0)
        assert [graph_node.full_name for graph_node in session.graph(0).nodes] == [node]
        process.interrupt()
        process.wait(2.0)
    assert "] [rviz2]: No notebook shows this window." in process.output


def test_without_its_file_it_shows_the_usual_view_and_says_so(tmp_path):
    with Session(virtual=True).use() as session:
        for file in ("no/such.rviz", str(tmp_path)):
            process = session.start_executable(find("rviz2", "rviz2"), ["-d", file], name="rviz2")
            session.clock.sleep(1.0)
            process.interrupt()
            assert process.wait(2.0) == 0, process.output
            assert f"{file}: there is no such file" in process.output and "RobotModel" in process.output


def test_display_launch_of_urdf_tutorial_runs_to_the_end():
    from coursekit.cli.parser import run

    with Session(virtual=True).use() as session:
        argv = ["launch", "urdf_tutorial", "display.launch.py", "gui:=false"]
        process = session.start(lambda: run(argv), name="ros2", argv=argv)
        session.clock.sleep(3.0)
        process.interrupt()
        process.wait(10.0)
    assert "No notebook shows this window. Fixed frame: base_link" in process.output
    assert "rviz2-3]: process has finished cleanly" in process.output


@pytest.mark.parametrize("package", ["turtle_tf2_py", "turtle_tf2_cpp"])
def test_the_tf2_tutorials_bring_the_window_that_they_open(package):
    config = read(Path(get_package_share_directory(package)) / "rviz" / "turtle_rviz.rviz")
    assert config.fixed_frame == "world"
    assert {"Grid", "TF"} <= {display.kind for display in config.displays if display.enabled}
