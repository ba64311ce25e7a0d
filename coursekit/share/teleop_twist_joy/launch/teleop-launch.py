"""A gamepad and what turns it into velocities; joy_config names a file of config/."""

import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration, TextSubstitution
from launch_ros.actions import Node


def generate_launch_description():
    """Return the two nodes and their arguments."""
    folder = os.path.join(get_package_share_directory("teleop_twist_joy"), "config", "")
    file = [TextSubstitution(text=folder), LaunchConfiguration("joy_config"), TextSubstitution(text=".config.yaml")]
    config = LaunchConfiguration("config_filepath")
    pad = {"device_id": LaunchConfiguration("joy_dev"), "deadzone": 0.3, "autorepeat_rate": 20.0}
    stamped = {"publish_stamped_twist": LaunchConfiguration("publish_stamped_twist")}
    return LaunchDescription(
        [
            DeclareLaunchArgument("joy_vel", default_value="cmd_vel"),
            DeclareLaunchArgument("joy_config", default_value="ps3"),
            DeclareLaunchArgument("joy_dev", default_value="0"),
            DeclareLaunchArgument("publish_stamped_twist", default_value="false"),
            DeclareLaunchArgument("config_filepath", default_value=file),
            Node(package="joy", executable="joy_node", name="joy_node", parameters=[pad, config]),
            Node(
                package="teleop_twist_joy",
                executable="teleop_node",
                name="teleop_twist_joy_node",
                parameters=[config, stamped],
                remappings=[("/cmd_vel", LaunchConfiguration("joy_vel"))],
            ),
        ]
    )
