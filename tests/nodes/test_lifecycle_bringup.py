"""nav2_util's lifecycle_bringup: the command that people type after they have started a map server."""

import numpy as np
import pytest

from coursekit.nav.map_file import GridMap, save_map


@pytest.fixture
def map_file(tmp_path):
    return save_map(tmp_path / "room", GridMap(np.zeros((2, 3), dtype=np.int8), 0.5))[0]


def test_nodes_are_configured_and_activated_in_order_without_a_word(run, ros2, map_file):
    run("nav2_map_server", "map_server", "--ros-args", "-p", f"yaml_filename:={map_file}")
    run("nav2_map_server", "map_saver_server", "--ros-args", "-r", "__node:=saver")
    process = run("nav2_util", "lifecycle_bringup", "map_server", "/saver", "--ros-args", "-r", "__node:=starter")
    assert process.wait(20.0) == 0 and process.output == ""
    for name in ("/map_server", "/saver"):
        assert ros2("lifecycle", "get", name) == "active [3]\n"


def test_a_node_that_is_nowhere_ends_it_with_what_to_look_at(session, run):
    process = run("nav2_util", "lifecycle_bringup", "mapp_server")
    before = session.clock.steady()
    assert process.wait(60.0) not in (0, None)
    assert session.clock.steady() - before >= 39e9  # it tries four times, ten seconds each, as nav2's does
    assert "what():  change_state service is not available!" in process.output
    assert "'mapp_server'" in process.output and "ros2 lifecycle nodes" in process.output


def test_without_names_it_tells_its_usage(run):
    process = run("nav2_util", "lifecycle_bringup")
    assert process.wait(5.0) == 1
    assert process.output.startswith("Invalid command line.\n") and " > lifecycle_startup <node name> ..." in process.output
