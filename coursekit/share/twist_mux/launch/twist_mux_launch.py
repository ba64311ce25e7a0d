"""twist_mux and the arrow of what it says."""

from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

CONFIG = Path(get_package_share_directory("twist_mux")) / "config"
FILES = {
    "config_locks": ("twist_mux_locks.yaml", "Default locks config file"),
    "config_topics": ("twist_mux_topics.yaml", "Default topics config file"),
    "config_joy": ("joystick.yaml", "Default joystick config file"),
}


def generate_launch_description():
    """Return the two nodes and their arguments."""
    use_sim_time = {"use_sim_time": LaunchConfiguration("use_sim_time")}
    out = LaunchConfiguration("cmd_vel_out")
    look = {"frame_id": "base_link", "scale": 1.0, "vertical_position": 2.0}
    return LaunchDescription(
        [
            *(
                DeclareLaunchArgument(name, default_value=str(CONFIG / file), description=text)
                for name, (file, text) in FILES.items()
            ),
            DeclareLaunchArgument("cmd_vel_out", default_value="twist_mux/cmd_vel", description="cmd vel output topic"),
            DeclareLaunchArgument("use_sim_time", default_value="False", description="Use simulation time"),
            Node(
                package="twist_mux",
                executable="twist_mux",
                output="screen",
                remappings=[("/cmd_vel_out", out)],
                parameters=[use_sim_time, *(LaunchConfiguration(name) for name in FILES)],
            ),
            Node(
                package="twist_mux",
                executable="twist_marker",
                output="screen",
                remappings=[("/twist", out)],
                parameters=[use_sim_time | look],
            ),
        ]
    )
