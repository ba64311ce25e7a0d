"""Masks on the map: where a robot may not go, and where it goes slowly, as nav2's keepout and speed zones."""

from pathlib import Path

import numpy as np
import pytest
import yaml
from ament_index_python.packages import get_package_share_directory
from nav2_msgs.action import NavigateToPose
from rclpy.action import ActionClient

from coursekit.geometry.plane import Pose2D
from coursekit.nav.map_file import GridMap, save_map
from coursekit.processes.executables import find
from tests.nodes.nav2_stage import CELL, ROBOT, Stage

KEEPOUT = {"plugin": "nav2_costmap_2d::KeepoutFilter", "enabled": True, "filter_info_topic": "/keepout_info"}
SPEED = {"plugin": "nav2_costmap_2d::SpeedFilter", "enabled": True, "filter_info_topic": "/speed_info"}


@pytest.fixture
def start(session, tmp_path):
    """start(name, type, base, multiplier, box, shade, filter) is a stage whose map has a mask in a box (x, y, x, y)."""
    stages = []

    def stage(kind, base, multiplier, box, shade, one):
        given = yaml.safe_load((Path(get_package_share_directory("nav2_bringup")) / "params/nav2_params.yaml").read_text())
        for name in ("local_costmap", "global_costmap"):
            given[name][name]["ros__parameters"] |= {"filters": ["zone"], "zone": one}
        file = tmp_path / "zones.yaml"
        file.write_text(yaml.safe_dump(given))
        mask = np.zeros((200, 200), np.int8)
        left, low, right, high = (round((edge + 5.0) / CELL) for edge in box)
        mask[low:high, left:right] = shade
        drawn = save_map(tmp_path / "mask", GridMap(mask, CELL, (-5.0, -5.0, 0.0)), mode="raw")[0]
        servers = {
            "map_server": ("filter_mask_server", {"yaml_filename": drawn, "topic_name": "/zones"}),
            "costmap_filter_info_server": ("costmap_filter_info_server", {
                "type": kind, "filter_info_topic": one["filter_info_topic"], "mask_topic": "/zones", "base": base,
                "multiplier": multiplier,
            }),
        }  # fmt: skip
        for executable, (node, parameters) in servers.items():
            words = [word for name, value in parameters.items() for word in ("-p", f"{name}:={value}")]
            argv = ["--ros-args", "-r", f"__node:={node}", *words]
            session.start_executable(find("nav2_map_server", executable), argv, name=executable)
        manager = ["-p", "node_names:=[filter_mask_server, costmap_filter_info_server]", "-p", "autostart:=true"]
        argv = ["--ros-args", "-r", "__node:=lifecycle_manager_zones", *manager]
        session.start_executable(find("nav2_lifecycle_manager", "lifecycle_manager"), argv, name="lifecycle_manager")
        stages.append(Stage(session, tmp_path, "tec_warehouse", ROBOT, f"params_file:={file}"))
        stages[0].tell_pose(Pose2D(0.0, 0.0, 0.0))
        return stages[0]

    yield stage
    stages[0].close()


def drive(stage, there):
    """The places and speeds of the robot on its way."""
    client = ActionClient(stage.node, NavigateToPose, "navigate_to_pose")
    assert client.wait_for_server(timeout_sec=5.0)
    future = stage.until(client.send_goal_async(NavigateToPose.Goal(pose=stage.stamped(there)))).get_result_async()
    seen = []
    for _ in range(500):
        stage.spin(0.1)
        seen.append((*stage.robot.place[:2], stage.robot.velocity[0]))
        if future.done():
            break
    assert future.result().status == 4 and stage.touched == {}
    return np.array(seen)


def test_a_robot_goes_around_a_zone_that_it_should_keep_out_of(start):
    stage = start(0, 0.0, 1.0, (1.4, -0.6, 2.0, 0.4), 100, KEEPOUT)
    seen = drive(stage, Pose2D(3.5, 0.0, 0.0))
    assert not ((seen[:, 0] > 1.4) & (seen[:, 0] < 2.0) & (seen[:, 1] > -0.6) & (seen[:, 1] < 0.4)).any()


def test_a_robot_goes_slowly_where_a_mask_says_so(start):
    stage = start(1, 100.0, -1.0, (1.0, -2.0, 2.5, 2.0), 75, SPEED)
    seen = drive(stage, Pose2D(4.0, 0.0, 0.0))
    inside = (seen[:, 0] > 1.3) & (seen[:, 0] < 2.4)
    assert seen[inside, 2].max() < 0.13 and seen[seen[:, 0] < 1.0, 2].max() > 0.35 < seen[seen[:, 0] > 2.7, 2].max()
