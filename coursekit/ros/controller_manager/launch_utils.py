"""Launch descriptions that spawn controllers."""

from __future__ import annotations

from typing import Any

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_load_controller_launch_description(
    controller_name: str,
    controller_type: str | None = None,
    controller_params_file: Any = None,
    extra_spawner_args: list[Any] | None = None,
) -> LaunchDescription:
    """A spawner of one controller, with the arguments `controller_manager_name` and `unload_on_kill`.

    >>> len(generate_load_controller_launch_description("joint_state_broadcaster").entities)
    3
    """
    manager, unload = LaunchConfiguration("controller_manager_name"), LaunchConfiguration("unload_on_kill")
    words: list[Any] = [controller_name, "--controller-manager", manager]
    for option, value in (("--controller-type", controller_type), ("--param-file", controller_params_file)):
        words += [option, value] if value else []
    words += [*(extra_spawner_args or []), PythonExpression(['"--unload-on-kill"', " if '", unload, "' == 'true' else ''"])]
    return LaunchDescription(
        [
            DeclareLaunchArgument("controller_manager_name", default_value=["controller_manager"]),
            DeclareLaunchArgument("unload_on_kill", default_value=["false"]),
            Node(package="controller_manager", executable="spawner", arguments=words, output="screen"),
        ]
    )
