"""The runner of launch tests of nodes."""

from __future__ import annotations

from typing import Any

import launch_testing.test_runner


class LaunchTestRunner(launch_testing.test_runner.LaunchTestRunner):
    """Runs launch tests with an `rclpy` context, which receives the ROS arguments among the launch's."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        import rclpy  # not at the top: a plugin of pytest imports this file

        self._rclpy_context = rclpy.context.Context()
        rclpy.init(args=self._launch_file_arguments, context=self._rclpy_context)
