"""The launch files start their node with the parameters of the file that is named."""

from __future__ import annotations

import pytest

from coursekit.cli.parser import run as run_cli


@pytest.mark.parametrize("name", ["online_async", "online_sync", "localization", "lifelong", "offline"])
def test_a_launch_file_starts_its_node_with_its_parameters(session, ros2, tmp_path, name):
    words = ["launch", "slam_toolbox", f"{name}_launch.py", "use_sim_time:=false"]
    process = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert "[slam_toolbox]: Using solver plugin solver_plugins::CeresSolver" in process.output
    often = "10.0" if name == "offline" else "0.5"
    assert f"Double value is: {often}" in ros2("param", "get", "/slam_toolbox", "map_update_interval")
    mode = "localization" if name == "localization" else "mapping"
    assert f"String value is: {mode}" in ros2("param", "get", "/slam_toolbox", "mode")
    process.interrupt()
    process.wait(10.0)


def test_another_parameter_file_can_be_named(session, ros2, tmp_path):
    file = tmp_path / "mine.yaml"
    file.write_text("slam_toolbox:\n  ros__parameters:\n    resolution: 0.1\n    scan_buffer_maximum_scan_distance: 10\n")
    words = ["launch", "slam_toolbox", "online_async_launch.py", f"slam_params_file:={file}", "use_sim_time:=false"]
    process = session.start(lambda: run_cli(words), name="ros2", argv=words)
    session.clock.sleep(3.0)
    assert "Double value is: 0.1" in ros2("param", "get", "/slam_toolbox", "resolution")
    assert "Integer value is: 10" in ros2("param", "get", "/slam_toolbox", "scan_buffer_maximum_scan_distance")
    process.interrupt()
    process.wait(10.0)
