"""pytest's plugin: a file whose `generate_test_description` has the mark `rostest` is a launch test of ROS.

Every run of pytest loads this module. The rest is imported when there is such a file.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any


def pytest_launch_collect_makemodule(module_path: Path, parent: Any, entrypoint: Any) -> Any:
    """Collect a file whose description has the mark `rostest`."""
    if not any(mark.name == "rostest" for mark in getattr(entrypoint, "pytestmark", [])):
        return None
    from launch_testing.pytest.hooks import marked_module
    from launch_testing_ros.pytest.hooks import LaunchROSTestModule

    return marked_module(LaunchROSTestModule, "rostest", module_path, parent, entrypoint)


def pytest_configure(config: Any) -> None:
    """Register the mark."""
    config.addinivalue_line(
        "markers",
        "rostest: mark a generate_test_description function as a ROS launch test entrypoint",
    )
